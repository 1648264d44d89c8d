#include "craze/products/growth/crack_sites.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace craze {

namespace {

/// Walks along the two sides of every crack edge that was split on one side only.
class SideMatcher {
 public:
  explicit SideMatcher(const TriangleMesh& mesh) : mesh_(mesh), merged_(mesh.vertex_count()) {
    std::iota(merged_.begin(), merged_.end(), 0);
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      if (mesh.crack_of(h) >= 0) sides_.push_back(h);
    }
    inner_.resize(sides_.size());
    find_unmatched();
    for (const std::int32_t i : unmatched_) {
      if (!is_done_[i]) match_from(i);
    }
  }

  CrackSites sites() const {
    CrackSites result;
    result.site_of.assign(mesh_.vertex_count(), -1);
    std::vector<std::int32_t> site_of_root(mesh_.vertex_count(), -1);
    const auto site = [&](std::int32_t v) {
      std::int32_t& s = site_of_root[find(mesh_.root(v))];
      if (s < 0) {
        s = static_cast<std::int32_t>(result.vertex.size());
        result.vertex.push_back(v);
      }
      return s;
    };
    for (const std::int32_t h : sides_) {
      for (const std::int32_t v : {mesh_.from(h), mesh_.to(h)}) result.site_of[v] = site(v);
    }
    result.sides = sides_;
    result.first.push_back(0);
    for (const auto& inner : inner_) {
      for (const std::int32_t v : inner) result.inner.push_back(site(v));
      result.first.push_back(static_cast<std::int32_t>(result.inner.size()));
    }
    return result;
  }

 private:
  std::int32_t find(std::int32_t root) const {
    while (merged_[root] != root) root = merged_[root];
    return root;
  }
  std::int32_t start_of(std::int32_t i) const { return mesh_.root(mesh_.from(sides_[i])); }
  std::int32_t end_of(std::int32_t i) const { return mesh_.root(mesh_.to(sides_[i])); }
  std::int32_t label(std::int32_t i) const { return mesh_.crack_of(sides_[i]); }

  void find_unmatched() {
    const auto key = [](std::int32_t a, std::int32_t b) {
      return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
    };
    const auto count = static_cast<std::int32_t>(sides_.size());
    std::unordered_map<std::uint64_t, std::int32_t> by_ends;
    for (std::int32_t i = 0; i < count; ++i) by_ends[key(start_of(i), end_of(i))] = i;
    is_done_.assign(sides_.size(), false);
    for (std::int32_t i = 0; i < count; ++i) {
      if (by_ends.count(key(end_of(i), start_of(i)))) continue;
      unmatched_.push_back(i);
      starting_[start_of(i)].push_back(i);
      ending_[end_of(i)].push_back(i);
    }
  }

  /// Of the open candidates at a root, the one of that crack whose far end lies most nearly in
  /// the direction given; −1 if none does.
  std::int32_t along(const std::unordered_map<std::int32_t, std::vector<std::int32_t>>& candidates,
                     bool by_start, std::int32_t root, std::int32_t crack,
                     const Vec3& direction) const {
    const auto found = candidates.find(root);
    if (found == candidates.end()) return -1;
    std::int32_t best = -1;
    double best_cosine = 0.99;
    for (const std::int32_t i : found->second) {
      const Vec3 far = mesh_.position(by_start ? end_of(i) : start_of(i));
      const double cosine = (far - mesh_.position(root)).normalized().dot(direction);
      if (!is_done_[i] && label(i) == crack && cosine > best_cosine) {
        best = i;
        best_cosine = cosine;
      }
    }
    return best;
  }

  /// If both sides begin at the start of side i, puts the points of each inside the other.
  void match_from(std::int32_t i) {
    const std::int32_t origin = start_of(i), crack = label(i);
    const Vec3& p = mesh_.position(origin);
    const Vec3 direction = (mesh_.position(end_of(i)) - p).normalized();
    std::int32_t j = along(ending_, false, origin, crack, direction);
    std::vector<std::int32_t> backward;  // the sides passed on the other side
    while (i >= 0 && j >= 0) {
      is_done_[i] = is_done_[j] = true;
      if (backward.empty() || backward.back() != j) backward.push_back(j);
      const std::int32_t a = end_of(i), b = start_of(j);
      if (a == b) break;
      const double da = (mesh_.position(a) - p).norm(), db = (mesh_.position(b) - p).norm();
      const bool together = std::abs(da - db) <= 1e-9 * std::max(da, db);
      if (together) merged_[find(a)] = find(b);
      if (!together && da < db) inner_[j].push_back(a);
      if (!together && db < da) inner_[i].push_back(b);
      if (together || da < db) i = along(starting_, true, a, crack, direction);
      if (together || db < da) j = along(ending_, false, b, crack, direction);
    }
    // These were met against their own direction.
    for (const std::int32_t k : backward) std::reverse(inner_[k].begin(), inner_[k].end());
  }

  const TriangleMesh& mesh_;
  std::vector<std::int32_t> sides_;
  std::vector<std::vector<std::int32_t>> inner_;  // per side: roots inside it
  std::vector<std::int32_t> merged_;              // union of roots that lie on one site
  std::vector<std::int32_t> unmatched_;           // indices into sides_
  std::vector<bool> is_done_;
  std::unordered_map<std::int32_t, std::vector<std::int32_t>> starting_, ending_;
};

}  // namespace

CrackSites crack_sites(const TriangleMesh& mesh) {
  return SideMatcher(mesh).sites();
}

}  // namespace craze
