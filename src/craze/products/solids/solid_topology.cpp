#include "craze/products/solids/solid_topology.h"

#include <algorithm>
#include <set>
#include <utility>

#include "craze/products/opening/wall_fans.h"

namespace craze {

namespace {

class Builder {
 public:
  Builder(const TriangleMesh& mesh, const CrackSites& sites)
      : mesh_(mesh), sites_(sites), side_of_(3 * mesh.triangles().size(), -1) {
    for (std::size_t i = 0; i < sites.sides.size(); ++i) {
      side_of_[sites.sides[i]] = static_cast<std::int32_t>(i);
    }
    add_bottoms();
  }

  SolidTopology run(const Shells* cores) {
    add_walls();
    made_.inner_begin = count();
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
      for (const Triangle& t : below(f)) add({t[0], t[2], t[1]}, f);
    }
    made_.core_begin = count();
    made_.core_bottom = static_cast<std::int32_t>(made_.bottoms.size());
    if (cores) add_cores(*cores);
    return std::move(made_);
  }

 private:
  std::int32_t count() const { return static_cast<std::int32_t>(made_.triangles.size()); }

  void add(const Triangle& triangle, std::int32_t face) {
    made_.triangles.push_back(triangle);
    made_.beside.push_back(face);
  }

  std::int32_t bottom(std::int32_t v) const { return mesh_.vertex_count() + v; }

  /// One below each vertex, then those below sites inside the edges of the other side's faces.
  void add_bottoms() {
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) made_.bottoms.push_back({v, v, v, 0});
    first_inside_ = static_cast<std::int32_t>(made_.bottoms.size());
    for (std::size_t i = 0; i < sites_.sides.size(); ++i) {
      const std::int32_t from = mesh_.from(sites_.sides[i]), to = mesh_.to(sites_.sides[i]);
      const Vec3 way = mesh_.position(to) - mesh_.position(from);
      for (std::int32_t k = sites_.first[i]; k < sites_.first[i + 1]; ++k) {
        const std::int32_t v = sites_.vertex[sites_.inner[k]];
        const double along = (mesh_.position(v) - mesh_.position(from)).dot(way);
        made_.bottoms.push_back({v, from, to, std::clamp(along / way.squaredNorm(), 0.0, 1.0)});
      }
    }
  }

  std::vector<std::int32_t> bottoms_inside(std::int32_t h) const {
    std::vector<std::int32_t> inside;
    const std::int32_t i = side_of_[h];
    if (i < 0) return inside;
    for (std::int32_t k = sites_.first[i]; k < sites_.first[i + 1]; ++k) {
      inside.push_back(bottom(first_inside_ + k));
    }
    return inside;
  }

  void add_walls() {
    // Between two tips both sides of an edge run between the same two vertices: it stays shut.
    std::set<std::pair<std::int32_t, std::int32_t>> ends;
    for (const std::int32_t h : sites_.sides) ends.emplace(mesh_.from(h), mesh_.to(h));
    const std::vector<std::size_t> fans = wall_fans(mesh_, sites_);
    for (std::int32_t h = 0; h < 3 * mesh_.face_count(); ++h) {
      if (!mesh_.is_open(h)) continue;
      const bool is_side = side_of_[h] >= 0;
      if (is_side && ends.count({mesh_.to(h), mesh_.from(h)})) continue;
      add_wall(h, is_side ? fans[side_of_[h]] : 0);
    }
  }

  void add_wall(std::int32_t h, std::size_t from_start) {
    const std::int32_t a = mesh_.from(h), b = mesh_.to(h), face = TriangleMesh::face_of(h);
    std::vector<std::int32_t> bottoms{bottom(a)};
    for (const std::int32_t v : bottoms_inside(h)) bottoms.push_back(v);
    bottoms.push_back(bottom(b));
    for (std::size_t i = 0; i + 1 < bottoms.size(); ++i) {
      if (i == from_start) add({a, bottoms[i], b}, face);
      add({i < from_start ? a : b, bottoms[i], bottoms[i + 1]}, face);
    }
    if (from_start + 1 == bottoms.size()) add({a, bottoms.back(), b}, face);
  }

  /// The bottoms below a face in its own order, divided where a site lies inside an edge.
  std::vector<Triangle> below(std::int32_t f) const {
    const Triangle& t = mesh_.triangle(f);
    std::vector<Triangle> parts{{bottom(t[0]), bottom(t[1]), bottom(t[2])}};
    for (int i = 0; i < 3; ++i) {
      std::int32_t from = bottom(t[i]);
      const std::int32_t to = bottom(t[(i + 1) % 3]);
      for (const std::int32_t v : bottoms_inside(3 * f + i)) {
        split(parts, from, to, v);
        from = v;
      }
    }
    return parts;
  }

  static void split(std::vector<Triangle>& parts, std::int32_t from, std::int32_t to,
                    std::int32_t v) {
    for (Triangle& t : parts) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (t[i] != from || t[(i + 1) % 3] != to) continue;
        const std::int32_t apex = t[(i + 2) % 3];
        t = {from, v, apex};
        parts.push_back({v, to, apex});
        return;
      }
    }
  }

  void add_cores(const Shells& shells) {
    // By shell: a number from 0 in their order, −1 for an open one.
    std::vector<std::int32_t> core_number(shells.is_closed.size(), -1);
    std::int32_t cores = 0;
    for (std::size_t s = 0; s < core_number.size(); ++s) {
      if (shells.is_closed[s]) core_number[s] = cores++;
    }
    std::vector<std::int32_t> core_of(made_.bottoms.size(), -1);
    const auto core = [&](std::int32_t b) {
      const std::int32_t v = made_.bottoms[b - mesh_.vertex_count()].vertex;
      const std::int32_t site = sites_.site_of[v];
      const std::int32_t owner = site < 0 ? v : sites_.vertex[site];
      if (core_of[owner] < 0) {
        core_of[owner] = bottom(static_cast<std::int32_t>(made_.bottoms.size()));
        made_.bottoms.push_back({owner, owner, owner, 0});
      }
      return core_of[owner];
    };
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
      const std::int32_t number = core_number[shells.of_vertex[mesh_.triangle(f)[0]]];
      if (number < 0) continue;
      for (const Triangle& t : below(f)) {
        add({core(t[0]), core(t[1]), core(t[2])}, f);
        made_.core.push_back(number);
      }
    }
  }

  const TriangleMesh& mesh_;
  const CrackSites& sites_;
  std::vector<std::int32_t> side_of_;  // 3 #F: which of the sides a halfedge is, or −1
  std::int32_t first_inside_ = 0;      // of the bottoms: below the first of sites.inner
  SolidTopology made_;
};

}  // namespace

SolidTopology solid_topology(const TriangleMesh& mesh, const CrackSites& sites,
                             const Shells* cores) {
  return Builder(mesh, sites).run(cores);
}

}  // namespace craze
