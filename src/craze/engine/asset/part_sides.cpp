#include "craze/engine/asset/part_sides.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace craze {

namespace {

/// A face's corner at a site, with the sites and vertices at its two other corners.
struct Corner {
  std::int32_t site, face, i, next, prev;
  std::int32_t next_vertex, prev_vertex;
};

/// Disjoint sets of a few corners; the lowest stands for its set.
class Sets {
 public:
  void reset(std::size_t n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::int32_t find(std::int32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::int32_t> parent_;
};

class SideParter {
 public:
  SideParter(const SurfaceMesh& asset, const AssetTopology& topology, SiteTable& sites,
             RefinedAsset& refined)
      : asset_(asset), topology_(topology), sites_(sites), refined_(refined) {}

  LineSides run() {
    index_lines();
    collect_corners();
    LineSides result = collect_sides();
    for (std::size_t i = 0, j = 0; i < corners_.size(); i = j) {
      while (j < corners_.size() && corners_[j].site == corners_[i].site) ++j;
      part(i, j);
    }
    return result;
  }

 private:
  // An edge of a corner: the vertices at its ends, the site at its far end.
  struct Spoke {
    std::int32_t vertex, other_vertex, other, corner;
  };
  // A vertex of the asset or refined asset in one fan of faces, and which sector has it.
  struct Owner {
    std::int32_t vertex, fan, sector, given;
  };

  void index_lines() {
    first_line_.assign(sites_.count() + 1, 0);
    for (const CurveLine& line : refined_.lines) ++first_line_[line.a + 1];
    std::partial_sum(first_line_.begin(), first_line_.end(), first_line_.begin());
  }

  std::int32_t line_between(std::int32_t a, std::int32_t b) const {
    if (a > b) std::swap(a, b);
    if (a + 1 >= static_cast<std::int32_t>(first_line_.size())) return -1;
    for (std::int32_t k = first_line_[a]; k < first_line_[a + 1]; ++k) {
      if (refined_.lines[k].b == b) return k;
    }
    return -1;
  }

  void add_corner(std::int32_t site, std::int32_t face, int i, std::int32_t next,
                  std::int32_t prev) {
    const Triangle& t = refined_.triangles[face];
    corners_.push_back({site, face, i, next, prev, t[(i + 1) % 3], t[(i + 2) % 3]});
  }

  void collect_corners() {
    std::vector<char> on_line(sites_.count(), 0);
    for (const CurveLine& line : refined_.lines) on_line[line.a] = on_line[line.b] = 1;
    for (std::size_t p = 0; p < refined_.parts.size(); ++p) {
      const std::int32_t* at = &refined_.part_sites[3 * p];
      for (int i = 0; i < 3; ++i) {
        if (!on_line[at[i]]) continue;
        add_corner(at[i], refined_.parts[p], i, at[(i + 1) % 3], at[(i + 2) % 3]);
      }
    }
    const auto is_split = [&](std::int32_t f) {
      return std::binary_search(refined_.parts.begin(), refined_.parts.end(), f);
    };
    const auto sites_before = static_cast<std::int32_t>(on_line.size());
    for (std::int32_t s = 0; s < sites_before; ++s) {
      if (!on_line[s] || sites_[s].kind != SiteKind::place) continue;
      for (const std::int32_t h : topology_.leaving(sites_[s].where)) {
        if (is_split(h / 3)) continue;
        const std::int32_t before = h % 3 == 0 ? h + 2 : h - 1;
        const std::int32_t next = sites_.at_place(topology_.to(h)),
                           prev = sites_.at_place(topology_.from(before));
        add_corner(s, h / 3, h % 3, next, prev);
      }
    }
    sort_corners(sites_before);
  }

  /// By site, then face: counted into place, and the few of a site put in order.
  void sort_corners(std::int32_t sites) {
    std::vector<std::int32_t> first(sites + 1, 0);
    for (const Corner& c : corners_) ++first[c.site + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    std::vector<Corner> sorted(corners_.size());
    for (const Corner& c : corners_) sorted[next[c.site]++] = c;
    for (std::int32_t s = 0; s < sites; ++s) {
      std::sort(sorted.begin() + first[s], sorted.begin() + first[s + 1],
                [](const Corner& a, const Corner& b) {
                  return a.face != b.face ? a.face < b.face : a.i < b.i;
                });
    }
    corners_ = std::move(sorted);
  }

  LineSides collect_sides() const {
    std::vector<std::int32_t> line(corners_.size());
    LineSides sides;
    sides.first.assign(refined_.lines.size() + 1, 0);
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      line[c] = line_between(corners_[c].site, corners_[c].next);
      if (line[c] >= 0) ++sides.first[line[c] + 1];
    }
    std::partial_sum(sides.first.begin(), sides.first.end(), sides.first.begin());
    sides.halfedges.resize(sides.first.back());
    std::vector<std::int32_t> next(sides.first.begin(), sides.first.end() - 1);
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      if (line[c] >= 0) sides.halfedges[next[line[c]]++] = 3 * corners_[c].face + corners_[c].i;
    }
    for (std::size_t k = 0; k < refined_.lines.size(); ++k) {
      std::sort(sides.halfedges.begin() + sides.first[k],
                sides.halfedges.begin() + sides.first[k + 1]);
    }
    return sides;
  }

  /// The corners [first, last) round one site.
  void part(std::size_t first, std::size_t last) {
    spokes_.clear();
    for (std::size_t c = first; c < last; ++c) {
      const auto corner = static_cast<std::int32_t>(c - first);
      const Corner& k = corners_[c];
      const std::int32_t v = refined_.triangles[k.face][k.i];
      spokes_.push_back({v, k.next_vertex, k.next, corner});
      spokes_.push_back({v, k.prev_vertex, k.prev, corner});
    }
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
      if (a.vertex != b.vertex) return a.vertex < b.vertex;
      if (a.other_vertex != b.other_vertex) return a.other_vertex < b.other_vertex;
      return a.corner < b.corner;
    });
    fans_.reset(last - first);
    sectors_.reset(last - first);
    const auto same = [](const Spoke& a, const Spoke& b) {
      return a.vertex == b.vertex && a.other_vertex == b.other_vertex;
    };
    for (std::size_t k = 0, end = 0; k < spokes_.size(); k = end) {
      while (end < spokes_.size() && same(spokes_[k], spokes_[end])) {
        fans_.join(spokes_[k].corner, spokes_[end++].corner);
      }
      // Where more than two faces meet it is open which of them go on into each other.
      const bool joins = end == k + 2 && line_between(corners_[first].site, spokes_[k].other) < 0;
      if (joins) sectors_.join(spokes_[k].corner, spokes_[k + 1].corner);
    }
    owners_.clear();
    for (std::size_t c = first; c < last; ++c) {
      const auto corner = static_cast<std::int32_t>(c - first);
      std::int32_t& v = refined_.triangles[corners_[c].face][corners_[c].i];
      v = given(v, fans_.find(corner), sectors_.find(corner), corners_[c]);
    }
  }

  std::int32_t given(std::int32_t v, std::int32_t fan, std::int32_t sector, const Corner& corner) {
    bool taken = false;
    for (const Owner& o : owners_) {
      if (o.vertex != v || o.fan != fan) continue;
      if (o.sector == sector) return o.given;
      taken = true;
    }
    const std::int32_t mine = taken ? copy(v, corner) : v;
    owners_.push_back({v, fan, sector, mine});
    return mine;
  }

  std::int32_t copy(std::int32_t v, const Corner& corner) {
    const auto made = static_cast<std::int32_t>(refined_.positions.size());
    const auto own = static_cast<std::int32_t>(asset_.positions.size());
    const Vec3 position = refined_.positions[v];
    refined_.positions.push_back(position);
    SurfacePoint at;
    if (v < own) {
      at.face = refined_.face_source[corner.face];
      const Triangle& t = asset_.triangles[at.face];
      at.weights[std::find(t.begin(), t.end(), v) - t.begin()] = 1;
    } else {
      at = refined_.new_vertices[v - own];
    }
    refined_.new_vertices.push_back(at);
    refined_.root.push_back(v);
    return made;
  }

  const SurfaceMesh& asset_;
  const AssetTopology& topology_;
  SiteTable& sites_;
  RefinedAsset& refined_;
  std::vector<std::int32_t> first_line_;  // #sites + 1: lines by their lower site
  std::vector<Corner> corners_;
  std::vector<Spoke> spokes_;
  std::vector<Owner> owners_;
  Sets fans_, sectors_;
};

}  // namespace

LineSides part_sides(const SurfaceMesh& asset, const AssetTopology& topology, SiteTable& sites,
                     RefinedAsset& refined) {
  return SideParter(asset, topology, sites, refined).run();
}

}  // namespace craze
