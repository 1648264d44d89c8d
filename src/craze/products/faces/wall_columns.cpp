#include "craze/products/faces/wall_columns.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace craze {

namespace {

class LineFinder {
 public:
  LineFinder(const TriangleMesh& mesh, const CrackSites& sites, double window)
      : mesh_(mesh),
        sites_(sites),
        window_(window),
        beside_(sites.vertex.size()),
        columns_(sites.vertex.size()) {
    for (std::size_t i = 0; i < sites.sides.size(); ++i) {
      std::int32_t before = sites.site_of[mesh.from(sites.sides[i])];
      for (std::int32_t k = sites.first[i]; k < sites.first[i + 1]; ++k) {
        join(before, sites.inner[k]);
        before = sites.inner[k];
      }
      join(before, sites.site_of[mesh.to(sites.sides[i])]);
    }
    for (auto& others : beside_) {
      std::sort(others.begin(), others.end());
      others.erase(std::unique(others.begin(), others.end()), others.end());
    }
    is_end_.resize(beside_.size());
    for (std::size_t s = 0; s < beside_.size(); ++s) is_end_[s] = beside_[s].size() != 2;
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      if (mesh.opposite(h) != TriangleMesh::border) continue;
      for (const std::int32_t v : {mesh.from(h), mesh.to(h)}) {
        if (sites.site_of[v] >= 0) is_end_[sites.site_of[v]] = 1;
      }
    }
  }

  std::vector<WallColumn> run() {
    is_done_ = is_end_;
    const auto count = static_cast<std::int32_t>(beside_.size());
    for (std::int32_t s = 0; s < count; ++s) {
      if (!is_end_[s]) continue;
      for (const std::int32_t next : beside_[s]) {
        if (!is_done_[next]) follow(s, next);
      }
    }
    for (std::int32_t s = 0; s < count; ++s) {
      if (!is_done_[s]) follow(s, beside_[s][0]);
    }
    return std::move(columns_);
  }

 private:
  void join(std::int32_t a, std::int32_t b) {
    if (a == b) return;
    beside_[a].push_back(b);
    beside_[b].push_back(a);
  }
  const Vec3& at(std::int32_t site) const { return mesh_.position(sites_.vertex[site]); }

  /// From an end to the next one, or all the way round.
  void follow(std::int32_t from, std::int32_t next) {
    std::vector<std::int32_t> line{from};
    std::vector<double> arc{0};
    for (;;) {
      arc.push_back(arc.back() + (at(next) - at(line.back())).norm());
      line.push_back(next);
      if (next == from || is_end_[next]) break;
      is_done_[next] = 1;
      const auto& both = beside_[next];
      next = both[0] == line[line.size() - 2] ? both[1] : both[0];
    }
    const bool is_ring = line.back() == from && !is_end_[from];
    if (is_ring) is_done_[from] = 1;
    const auto last = static_cast<std::ptrdiff_t>(line.size()) - 1;
    for (std::ptrdiff_t i = is_ring ? 0 : 1; i < last; ++i) {
      std::ptrdiff_t back = i, ahead = i;
      while (back > 0 && arc[i] - arc[back] < window_) --back;
      while (ahead < last && arc[ahead] - arc[i] < window_) ++ahead;
      WallColumn& column = columns_[line[i]];
      column.along = (at(line[ahead]) - at(line[back])).stableNormalized();
      column.to_end =
          is_ring ? std::numeric_limits<double>::infinity() : std::min(arc[i], arc.back() - arc[i]);
    }
  }

  const TriangleMesh& mesh_;
  const CrackSites& sites_;
  double window_;
  std::vector<std::vector<std::int32_t>> beside_;  // per site: the next ones along cracks
  std::vector<std::uint8_t> is_end_, is_done_;     // per site
  std::vector<WallColumn> columns_;
};

}  // namespace

std::vector<WallColumn> wall_columns(const TriangleMesh& mesh, const CrackSites& sites,
                                     double window) {
  return LineFinder(mesh, sites, window).run();
}

}  // namespace craze
