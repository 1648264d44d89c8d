#include "craze/engine/asset/refine_asset.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "craze/engine/asset/triangulate_face.h"

namespace craze {

namespace {

constexpr std::int32_t least_tolerance = 1 << 10, most_tolerance = grid / 64;

class Refiner {
 public:
  Refiner(const SurfaceMesh& asset, const AssetTopology& topology, SiteTable& sites,
          const std::vector<CurvePiece>& pieces, double snap)
      : asset_(asset), topology_(topology), sites_(sites), pieces_(pieces), snap_(snap) {}

  RefinedAsset run(const std::vector<std::int32_t>& points) {
    result_.positions = asset_.positions;
    result_.triangles = asset_.triangles;
    result_.face_source.resize(asset_.triangles.size());
    std::iota(result_.face_source.begin(), result_.face_source.end(), 0);
    result_.same_site.resize(sites_.count());
    std::iota(result_.same_site.begin(), result_.same_site.end(), 0);
    find_used(points);
    collect();
    local_.assign(sites_.count(), -1);
    vertex_.assign(sites_.count(), -1);
    for (std::size_t i = 0, j = 0; i < items_.size(); i = j) {
      while (j < items_.size() && items_[j].face == items_[i].face) ++j;
      split_face(i, j);
    }
    order_parts();
    order_lines();
    return std::move(result_);
  }

 private:
  // What a face has in it: a site or, after all sites, a piece.
  struct Item {
    std::int32_t face, site, piece;
  };
  // The vertices of an edge's site: one for each pair of vertices that faces there have at its
  // ends.
  struct EdgeVertex {
    std::int32_t low, high, vertex, next;
  };
  struct Part {
    std::int32_t face;
    std::array<std::int32_t, 3> sites;
  };

  void find_used(const std::vector<std::int32_t>& points) {
    used_.assign(sites_.count(), 0);
    for (const std::int32_t s : points) used_[s] = 1;
    for (const CurvePiece& piece : pieces_) used_[piece.from] = used_[piece.to] = 1;
  }

  void collect() {
    const std::int32_t last = sites_.count();
    for (std::int32_t s = 0; s < last; ++s) {
      if (!used_[s] || sites_[s].kind == SiteKind::place) continue;
      sites_.for_each_face(s, [&](std::int32_t f) {
        items_.push_back({f, s, -1});
        return true;
      });
    }
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      items_.push_back({pieces_[p].face, last, static_cast<std::int32_t>(p)});
    }
    std::sort(items_.begin(), items_.end(), [](const Item& a, const Item& b) {
      if (a.face != b.face) return a.face < b.face;
      return a.site != b.site ? a.site < b.site : a.piece < b.piece;
    });
  }

  void split_face(std::size_t first, std::size_t last) {
    const std::int32_t f = items_[first].face;
    if (items_[first].piece >= 0) {  // along its edges only
      for (std::size_t i = first; i < last; ++i) {
        const CurvePiece& p = pieces_[items_[i].piece];
        add_line(p.from, p.to, p.curve_edge);
      }
      return;
    }
    draw_face(first, last);
    const Vec3 normal = triangulate(f);
    bool sound = is_sound(normal);
    while (!sound && drawing_.tolerance < most_tolerance) {
      drawing_.tolerance *= 16;
      triangulate(f);
      sound = is_sound(normal);
    }
    if (!sound) {
      result_.lost_segments += static_cast<std::int32_t>(drawing_.segments.size());
      drawing_.segments.clear();
      triangulate(f);
    }
    result_.lost_segments += triangulator_.lost();
    keep_triangles(f);
    for (const std::int32_t s : site_of_) local_[s] = -1;
  }

  void add_point(std::int32_t site, const GridPoint& at) {
    local_[site] = static_cast<std::int32_t>(site_of_.size());
    site_of_.push_back(site);
    drawing_.points.push_back(at);
  }

  void draw_face(std::size_t first, std::size_t last) {
    const std::int32_t f = items_[first].face;
    drawing_.points.clear();
    drawing_.segments.clear();
    site_of_.clear();
    const auto place = [&](int i) {
      const std::int32_t s = sites_.at_place(topology_.from(3 * f + i));
      grow();
      return s;
    };
    for (int i = 0; i < 3; ++i) add_point(place(i), on_grid_edge(i, 0));
    for (int i = 0; i < 3; ++i) {
      const std::int32_t h = 3 * f + i, edge = topology_.edge(h);
      const std::size_t before = site_of_.size();
      if (edge >= 0) {
        const auto add = [&](const EdgeSite& s, std::int32_t at) {
          if (used_[s.site]) add_point(s.site, on_grid_edge(i, at));
        };
        const std::vector<EdgeSite>& on = sites_.on_edge(edge);
        if (topology_.from(h) < topology_.to(h)) {
          for (const EdgeSite& s : on) add(s, s.at);
        } else {
          for (auto s = on.rbegin(); s != on.rend(); ++s) add(*s, grid - s->at);
        }
      }
      drawing_.on_edge[i] = static_cast<std::int32_t>(site_of_.size() - before);
    }
    for (std::size_t k = first; k < last; ++k) {
      if (items_[k].piece < 0) {
        const Site& s = sites_[items_[k].site];
        if (s.kind == SiteKind::face) add_point(items_[k].site, s.in_face);
      } else {
        const CurvePiece& p = pieces_[items_[k].piece];
        drawing_.segments.push_back({local_[p.from], local_[p.to], p.curve_edge});
      }
    }
    const Triangle& t = asset_.triangles[f];
    const Period& period = sites_.period();
    const Vec3 e = period.shortest(asset_.positions[t[1]] - asset_.positions[t[0]]),
               g = period.shortest(asset_.positions[t[2]] - asset_.positions[t[0]]);
    drawing_.metric = {e.dot(e), e.dot(g), g.dot(g)};
    const double longest = std::sqrt(std::max({e.dot(e), g.dot(g), (g - e).squaredNorm()}));
    const double share = longest > 0 ? snap_ / longest * grid : 0;
    drawing_.tolerance = static_cast<std::int32_t>(std::clamp(
        share, static_cast<double>(least_tolerance), static_cast<double>(most_tolerance)));
  }

  void grow() {
    local_.resize(sites_.count(), -1);
    vertex_.resize(sites_.count(), -1);
    used_.resize(sites_.count(), 1);
  }

  /// Returns the face's normal, its length twice the area.
  Vec3 triangulate(std::int32_t f) {
    triangulator_.run(drawing_);
    const Triangle& t = asset_.triangles[f];
    const Period& period = sites_.period();
    const Vec3 &a = asset_.positions[t[0]], b = period.nearest(asset_.positions[t[1]], a),
               c = period.nearest(asset_.positions[t[2]], a);
    place_.clear();
    for (std::size_t p = 0; p < triangulator_.points().size(); ++p) {
      if (p < site_of_.size()) {
        place_.push_back(period.nearest(sites_.position(site_of_[p]), a));
      } else {
        const Vec3 w = weights_of(triangulator_.points()[p]);
        place_.emplace_back(w[0] * a + w[1] * b + w[2] * c);
      }
    }
    return (b - a).cross(c - a);
  }

  /// Whether no triangle is turned over or flat once its corners are rounded. A face that is flat
  /// itself cannot be asked.
  bool is_sound(const Vec3& normal) const {
    if (normal.isZero(0)) return true;
    for (std::int32_t k = 0; k < triangulator_.triangle_count(); ++k) {
      const Triangle t = triangulator_.triangle(k);
      const Vec3& p = place_[t[0]];
      if (!((place_[t[1]] - p).cross(place_[t[2]] - p).dot(normal) > 0)) return false;
    }
    return true;
  }

  void keep_triangles(std::int32_t f) {
    const std::size_t drawn = drawing_.points.size();
    for (std::size_t p = 0; p < drawn; ++p) {
      const std::int32_t same = triangulator_.same_as()[p];
      if (site_of_[p] < static_cast<std::int32_t>(result_.same_site.size())) {
        result_.same_site[site_of_[p]] = site_of_[same];
      }
    }
    for (std::size_t p = drawn; p < triangulator_.points().size(); ++p) {
      site_of_.push_back(sites_.add(f, triangulator_.points()[p]));
    }
    grow();
    for (const FaceSegment& line : triangulator_.lines()) {
      add_line(site_of_[line.a], site_of_[line.b], line.label);
    }
    corner_vertex_.assign(site_of_.size(), -1);
    for (std::int32_t k = 0; k < triangulator_.triangle_count(); ++k) {
      const Triangle t = triangulator_.triangle(k);
      Triangle made;
      for (int i = 0; i < 3; ++i) {
        std::int32_t& v = corner_vertex_[t[i]];
        if (v < 0) v = vertex(f, t[i]);
        made[i] = v;
      }
      const std::array<std::int32_t, 3> at{site_of_[t[0]], site_of_[t[1]], site_of_[t[2]]};
      if (k == 0) {
        result_.triangles[f] = made;
        first_parts_.push_back({f, at});
      } else {
        other_parts_.push_back({static_cast<std::int32_t>(result_.triangles.size()), at});
        result_.triangles.push_back(made);
        result_.face_source.push_back(f);
      }
    }
  }

  std::int32_t make_vertex(std::int32_t f, std::int32_t local) {
    const auto v = static_cast<std::int32_t>(result_.positions.size());
    result_.positions.push_back(place_[local]);
    result_.new_vertices.push_back({f, weights_of(triangulator_.points()[local])});
    return v;
  }

  /// The vertex of the face's point.
  std::int32_t vertex(std::int32_t f, std::int32_t local) {
    const std::int32_t site = site_of_[local];
    if (local < 3) return asset_.triangles[f][local];
    if (sites_[site].kind != SiteKind::edge) {
      if (vertex_[site] < 0) vertex_[site] = make_vertex(f, local);
      return vertex_[site];
    }
    int i = 0;
    while (topology_.edge(3 * f + i) != sites_[site].where) ++i;
    const auto [low, high] =
        std::minmax({asset_.triangles[f][i], asset_.triangles[f][(i + 1) % 3]});
    for (std::int32_t k = vertex_[site]; k >= 0; k = edge_vertices_[k].next) {
      const EdgeVertex& known = edge_vertices_[k];
      if (known.low == low && known.high == high) return known.vertex;
    }
    const std::int32_t v = make_vertex(f, local);
    edge_vertices_.push_back({low, high, v, vertex_[site]});
    vertex_[site] = static_cast<std::int32_t>(edge_vertices_.size()) - 1;
    return v;
  }

  void add_line(std::int32_t a, std::int32_t b, std::int32_t curve_edge) {
    if (a > b) std::swap(a, b);
    result_.lines.push_back({a, b, curve_edge});
  }

  /// First parts stand where their faces stood, below all others; both kinds came in order.
  void order_parts() {
    for (const std::vector<Part>* kind : {&first_parts_, &other_parts_}) {
      for (const Part& part : *kind) {
        result_.parts.push_back(part.face);
        result_.part_sites.insert(result_.part_sites.end(), part.sites.begin(), part.sites.end());
      }
    }
  }

  void order_lines() {
    std::vector<CurveLine>& lines = result_.lines;
    std::sort(lines.begin(), lines.end(), [](const CurveLine& a, const CurveLine& b) {
      if (a.a != b.a) return a.a < b.a;
      return a.b != b.b ? a.b < b.b : a.curve_edge < b.curve_edge;
    });
    const auto same = [](const CurveLine& a, const CurveLine& b) {
      return a.a == b.a && a.b == b.b;
    };
    lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
  }

  const SurfaceMesh& asset_;
  const AssetTopology& topology_;
  SiteTable& sites_;
  const std::vector<CurvePiece>& pieces_;
  double snap_;
  RefinedAsset result_;
  std::vector<char> used_;           // #sites
  std::vector<Item> items_;          // by face
  std::vector<std::int32_t> local_;  // #sites: its point in the present face, −1: none
  std::vector<std::int32_t>
      vertex_;  // #sites: in a face its vertex, on an edge into edge_vertices_
  std::vector<EdgeVertex> edge_vertices_;
  std::vector<Part> first_parts_, other_parts_;
  // The present face.
  FaceDrawing drawing_;
  FaceTriangulator triangulator_;
  std::vector<std::int32_t> site_of_;        // per point
  std::vector<Vec3> place_;                  // per point
  std::vector<std::int32_t> corner_vertex_;  // per point
};

}  // namespace

RefinedAsset refine_asset(const SurfaceMesh& asset, const AssetTopology& topology, SiteTable& sites,
                          const std::vector<CurvePiece>& pieces,
                          const std::vector<std::int32_t>& points, double snap) {
  return Refiner(asset, topology, sites, pieces, snap).run(points);
}

}  // namespace craze
