#include "craze/engine/asset/lone_lines.h"

#include <algorithm>
#include <array>
#include <utility>

namespace craze {

namespace {

struct Side {
  std::int32_t line, halfedge;
  std::int32_t a, b;  // the vertices at its ends
};

class Halver {
 public:
  Halver(const AssetTopology& topology, SiteTable& sites, RefinedAsset& refined)
      : topology_(topology), sites_(sites), refined_(refined) {}

  void run() {
    find_lines();
    if (lone_.empty()) return;
    for (const Side& side : find_sides()) halve(side);
    for (const auto& [line, middle] : middles_) {
      const CurveLine whole = refined_.lines[line];
      refined_.lines.push_back({whole.b, middle, whole.curve_edge});  // no site is numbered higher
      refined_.lines[line].b = middle;
    }
    std::sort(refined_.lines.begin(), refined_.lines.end(),
              [](const CurveLine& a, const CurveLine& b) {
                return a.a < b.a || (a.a == b.a && a.b < b.b);
              });
  }

 private:
  void find_lines() {
    std::vector<std::int32_t> degree(sites_.count(), 0);
    for (const CurveLine& line : refined_.lines) {
      ++degree[line.a];
      ++degree[line.b];
    }
    for (std::size_t k = 0; k < refined_.lines.size(); ++k) {
      const CurveLine& line = refined_.lines[k];
      if (degree[line.a] == 1 && degree[line.b] == 1) lone_.push_back(static_cast<std::int32_t>(k));
    }
  }

  /// The lone line between two sites, or −1.
  std::int32_t lone_between(std::int32_t a, std::int32_t b) const {
    if (a > b) std::swap(a, b);
    const auto& lines = refined_.lines;
    const auto at = std::lower_bound(lone_.begin(), lone_.end(), 0, [&](std::int32_t k, int) {
      return lines[k].a < a || (lines[k].a == a && lines[k].b < b);
    });
    return at != lone_.end() && lines[*at].a == a && lines[*at].b == b ? *at : -1;
  }

  std::vector<Side> find_sides() const {
    std::vector<Side> sides;
    const auto add = [&](std::int32_t line, std::int32_t h) {
      const Triangle& t = refined_.triangles[h / 3];
      sides.push_back({line, h, t[h % 3], t[(h + 1) % 3]});
    };
    for (std::size_t p = 0; p < refined_.parts.size(); ++p) {
      for (int i = 0; i < 3; ++i) {
        const std::int32_t line =
            lone_between(refined_.part_sites[3 * p + i], refined_.part_sites[3 * p + (i + 1) % 3]);
        if (line >= 0) add(line, 3 * refined_.parts[p] + i);
      }
    }
    for (const std::int32_t k : lone_) {  // along edges of faces that are whole
      const CurveLine& line = refined_.lines[k];
      if (sites_[line.a].kind != SiteKind::place || sites_[line.b].kind != SiteKind::place)
        continue;
      for (const std::int32_t h : topology_.leaving(sites_[line.a].where)) {
        const std::int32_t before = h % 3 == 0 ? h + 2 : h - 1, other = sites_[line.b].where;
        if (std::binary_search(refined_.parts.begin(), refined_.parts.end(), h / 3)) continue;
        if (topology_.to(h) == other) add(k, h);
        if (topology_.from(before) == other) add(k, before);
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
      return x.line != y.line ? x.line < y.line : x.halfedge < y.halfedge;
    });
    return sides;
  }

  /// The index of a face among the parts; a whole face becomes one.
  std::size_t part_of(std::int32_t f) {
    const auto at = std::lower_bound(refined_.parts.begin(), refined_.parts.end(), f);
    const auto p = static_cast<std::size_t>(at - refined_.parts.begin());
    if (at != refined_.parts.end() && *at == f) return p;
    refined_.parts.insert(at, f);
    const std::array<std::int32_t, 3> corners{sites_.at_place(topology_.from(3 * f)),
                                              sites_.at_place(topology_.from(3 * f + 1)),
                                              sites_.at_place(topology_.from(3 * f + 2))};
    refined_.part_sites.insert(refined_.part_sites.begin() + static_cast<std::ptrdiff_t>(3 * p),
                               corners.begin(), corners.end());
    return p;
  }

  void halve(const Side& side) {
    const std::int32_t f = side.halfedge / 3, i = side.halfedge % 3, j = (i + 1) % 3;
    const std::int32_t source = refined_.face_source[f];
    const std::size_t p = part_of(f);
    const CurveLine& line = refined_.lines[side.line];
    if (middles_.empty() || middles_.back().first != side.line) {
      middles_.emplace_back(side.line, sites_.add_between(source, line.a, line.b));
      vertices_.clear();
    }
    const std::int32_t middle = middles_.back().second, v = vertex(side, middle, source);
    const auto made = static_cast<std::int32_t>(refined_.triangles.size());
    Triangle half = refined_.triangles[f];
    half[i] = v;
    refined_.triangles[f][j] = v;
    refined_.triangles.push_back(half);
    refined_.face_source.push_back(source);
    std::array<std::int32_t, 3> at{refined_.part_sites[3 * p], refined_.part_sites[3 * p + 1],
                                   refined_.part_sites[3 * p + 2]};
    refined_.part_sites[3 * p + j] = middle;
    at[i] = middle;
    refined_.parts.push_back(made);
    refined_.part_sites.insert(refined_.part_sites.end(), at.begin(), at.end());
  }

  /// The middle's vertex between those at the side's ends.
  std::int32_t vertex(const Side& side, std::int32_t middle, std::int32_t source) {
    const std::pair<std::int32_t, std::int32_t> ends = std::minmax(side.a, side.b);
    for (const auto& [known, v] : vertices_) {
      if (known == ends) return v;
    }
    const auto v = static_cast<std::int32_t>(refined_.positions.size());
    refined_.positions.push_back(sites_.position(middle));
    refined_.new_vertices.push_back({source, weights_of(sites_.in_face(middle, source))});
    vertices_.emplace_back(ends, v);
    return v;
  }

  const AssetTopology& topology_;
  SiteTable& sites_;
  RefinedAsset& refined_;
  std::vector<std::int32_t> lone_;                              // lines, ascending
  std::vector<std::pair<std::int32_t, std::int32_t>> middles_;  // (line, site)
  // The present line's new vertices by the vertices at its ends.
  std::vector<std::pair<std::pair<std::int32_t, std::int32_t>, std::int32_t>> vertices_;
};

}  // namespace

void halve_lone_lines(const AssetTopology& topology, SiteTable& sites, RefinedAsset& refined) {
  Halver(topology, sites, refined).run();
}

}  // namespace craze
