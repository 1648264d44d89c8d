#include "craze/products/distance/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "craze/base/random.h"

namespace craze {

namespace {

using Ends = std::array<double, 6>;

/// How far two sides may lie apart, relative to their length: files round to single precision.
constexpr double apart = 1e-5;

Ends ends(const Vec3& a, const Vec3& b) {
  return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
}

/// Segments by the cells of a grid that they pass.
class SegmentGrid {
 public:
  SegmentGrid(const TriangleMesh& mesh, const std::vector<std::int32_t>& halfedges)
      : mesh_(mesh), halfedges_(halfedges) {
    double total = 0;
    for (const std::int32_t h : halfedges) total += vector(h).norm();
    size_ = halfedges.empty() ? 1 : std::max(total / static_cast<double>(halfedges.size()), 1e-300);
    for (std::size_t i = 0; i < halfedges.size(); ++i) {
      const Vec3& a = mesh.position(mesh.from(halfedges[i]));
      const Vec3 d = vector(halfedges[i]);
      // Half a cell per step, so that with its neighbours no cell on the way is missed.
      const int steps = 1 + static_cast<int>(std::min(2 * d.norm() / size_, 1e6));
      for (int s = 0; s <= steps; ++s) {
        auto& cell = cells_[key(index(a + d * s / steps))];
        if (cell.empty() || cell.back() != i) cell.push_back(i);
      }
    }
  }

  /// Whether the middle of h lies on another segment that runs the other way.
  bool is_covered(std::int32_t h) const {
    const Vec3 middle = (mesh_.position(mesh_.from(h)) + mesh_.position(mesh_.to(h))) / 2;
    const Vec3 direction = vector(h).normalized();
    const std::array<std::int64_t, 3> at = index(middle);
    for (std::int64_t i = -1; i <= 1; ++i) {
      for (std::int64_t j = -1; j <= 1; ++j) {
        for (std::int64_t k = -1; k <= 1; ++k) {
          const auto cell = cells_.find(key({at[0] + i, at[1] + j, at[2] + k}));
          if (cell == cells_.end()) continue;
          for (const std::size_t s : cell->second) {
            if (halfedges_[s] != h && holds(halfedges_[s], middle, direction)) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  Vec3 vector(std::int32_t h) const {
    return mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h));
  }
  std::array<std::int64_t, 3> index(const Vec3& p) const {
    const auto cell = [&](double x) { return static_cast<std::int64_t>(std::floor(x / size_)); };
    return {cell(p.x()), cell(p.y()), cell(p.z())};
  }
  static std::uint64_t key(const std::array<std::int64_t, 3>& i) {
    return hash_bits(
        static_cast<std::uint64_t>(i[0]) ^
        hash_bits(static_cast<std::uint64_t>(i[1]) ^ hash_bits(static_cast<std::uint64_t>(i[2]))));
  }
  bool holds(std::int32_t g, const Vec3& point, const Vec3& direction) const {
    const Vec3 a = mesh_.position(mesh_.from(g)), d = vector(g);
    const double length = d.norm();
    if (length == 0 || d.dot(direction) > -0.999 * length) return false;
    const double along = (point - a).dot(d) / length;
    return along > 0 && along < length && (point - a - along / length * d).norm() <= apart * length;
  }

  const TriangleMesh& mesh_;
  const std::vector<std::int32_t>& halfedges_;
  double size_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

}  // namespace

std::vector<std::int32_t> seam_sides(const TriangleMesh& mesh) {
  std::vector<std::int32_t> borders;
  std::vector<Ends> known;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) != TriangleMesh::border) continue;
    borders.push_back(h);
    known.push_back(ends(mesh.position(mesh.from(h)), mesh.position(mesh.to(h))));
  }
  std::sort(known.begin(), known.end());
  std::vector<std::int32_t> seams, alone;
  for (const std::int32_t h : borders) {
    const Ends back = ends(mesh.position(mesh.to(h)), mesh.position(mesh.from(h)));
    const bool matched = std::binary_search(known.begin(), known.end(), back);
    (matched ? seams : alone).push_back(h);
  }
  const SegmentGrid grid(mesh, alone);
  for (const std::int32_t h : alone) {
    if (grid.is_covered(h)) seams.push_back(h);
  }
  std::sort(seams.begin(), seams.end());
  return seams;
}

}  // namespace craze
