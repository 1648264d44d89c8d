#include "craze/engine/asset/curve_sites.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace craze {

namespace {

constexpr double least_share = 0x1p-20;  // of an edge or face: a thousand steps of the grid
constexpr double most_share = 1.0 / 16;
constexpr double safe_roundings = 1024;  // what is so many roundings apart is apart

}  // namespace

SiteTable::SiteTable(const SurfaceMesh& asset, const AssetTopology& topology, double snap,
                     const Period& period)
    : asset_(asset),
      topology_(topology),
      snap_(snap),
      period_(period),
      of_place_(asset.positions.size(), -1),
      of_edge_(topology.edge_count(), -1) {
  double largest = 0;
  for (const Vec3& p : asset.positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  rounding_ = largest * std::numeric_limits<double>::epsilon();
}

/// How much of a length is too near to its end.
double SiteTable::edge_share(double length) const {
  const double near = std::max(snap_, safe_roundings * rounding_);
  return near < most_share * length ? std::max(near / length, least_share) : most_share;
}

std::int32_t SiteTable::at_place(std::int32_t place) {
  std::int32_t& site = of_place_[place];
  if (site < 0) {
    site = count();
    sites_.push_back({SiteKind::place, place});
  }
  return site;
}

std::int32_t SiteTable::on_halfedge(std::int32_t h, double s) {
  const std::int32_t a = topology_.from(h), b = topology_.to(h), edge = topology_.edge(h);
  const double length = period_.shortest(asset_.positions[b] - asset_.positions[a]).norm();
  const double near = edge_share(length);
  if (!(s >= near)) return at_place(a);
  if (s > 1 - near) return at_place(b);
  const auto steps = static_cast<std::int32_t>(std::lround(s * grid));
  const std::int32_t at = a < b ? steps : grid - steps;
  if (of_edge_[edge] < 0) {
    of_edge_[edge] = static_cast<std::int32_t>(edge_sites_.size());
    edge_sites_.emplace_back();
  }
  std::vector<EdgeSite>& others = edge_sites_[of_edge_[edge]];
  const auto above = std::lower_bound(others.begin(), others.end(), at,
                                      [](const EdgeSite& o, std::int32_t t) { return o.at < t; });
  const double reach = near * grid;
  const double up = above == others.end() ? grid : above->at - at;
  const double down = above == others.begin() ? grid : at - (above - 1)->at;
  if (std::min(up, down) < reach) return up <= down ? above->site : (above - 1)->site;
  const std::int32_t site = count();
  others.insert(above, {at, site});
  sites_.push_back({SiteKind::edge, edge, at});
  return site;
}

std::int32_t SiteTable::at(const SurfacePoint& point) {
  const std::int32_t f = point.face;
  const Vec3& w = point.weights;
  const std::int32_t corner[3] = {topology_.from(3 * f), topology_.from(3 * f + 1),
                                  topology_.from(3 * f + 2)};
  const Vec3& a = asset_.positions[corner[0]];
  const Vec3 b = period_.nearest(asset_.positions[corner[1]], a),
             c = period_.nearest(asset_.positions[corner[2]], a);
  const double double_area = (b - a).cross(c - a).norm();
  const Vec3 p = w[0] * a + w[1] * b + w[2] * c;
  // The edges that the point is too near to; the nearest of them by its share of the height.
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const std::int32_t h = 3 * f + i;
    const double length =
        period_.shortest(asset_.positions[topology_.to(h)] - asset_.positions[corner[i]]).norm();
    const double height = length > 0 ? double_area / length : 0;
    const double share = w[(i + 2) % 3], near = edge_share(height);
    if (share < near && share / near < least && topology_.edge(h) >= 0) {
      least = share / near;
      nearest = i;
    }
  }
  if (nearest >= 0) {
    const std::int32_t h = 3 * f + nearest;
    const double from = std::max(w[nearest], 0.0), to = std::max(w[(nearest + 1) % 3], 0.0);
    // The foot of the perpendicular, or where a face has no height the same ratio.
    const Vec3 origin = period_.nearest(asset_.positions[topology_.from(h)], p);
    const Vec3 edge = period_.shortest(asset_.positions[topology_.to(h)] - origin);
    const double foot = (p - origin).dot(edge) / edge.squaredNorm();
    const bool sound = foot >= 0 && foot <= 1;
    return on_halfedge(h, w[(nearest + 2) % 3] > 0 && sound ? foot
                          : from + to > 0                   ? to / (from + to)
                                                            : 0);
  }
  return add(f, {static_cast<std::int32_t>(std::lround(w[1] * grid)),
                 static_cast<std::int32_t>(std::lround(w[2] * grid))});
}

std::int32_t SiteTable::add(std::int32_t face, const GridPoint& at) {
  sites_.push_back({SiteKind::face, face, 0, at});
  return count() - 1;
}

std::int32_t SiteTable::add_between(std::int32_t face, std::int32_t a, std::int32_t b) {
  const GridPoint p = in_face(a, face), q = in_face(b, face);
  const auto half = [](std::int32_t x, std::int32_t y) { return x + (y - x) / 2; };
  const auto low = [](const GridPoint& m, int i) {  // steps from corner i along edge i
    return i == 0 ? m.x : i == 1 ? m.y : grid - m.y;
  };
  for (int i = 0; i < 3; ++i) {
    if (weights_of(p)[(i + 2) % 3] != 0 || weights_of(q)[(i + 2) % 3] != 0) continue;
    const std::int32_t h = 3 * face + i, steps = half(low(p, i), low(q, i));
    const std::int32_t at = topology_.from(h) < topology_.to(h) ? steps : grid - steps;
    sites_.push_back({SiteKind::edge, topology_.edge(h), at});
    return count() - 1;
  }
  return add(face, {half(p.x, q.x), half(p.y, q.y)});
}

Vec3 SiteTable::position(std::int32_t site, const std::vector<Vec3>& p) const {
  const Site& s = sites_[site];
  if (s.kind == SiteKind::place) return p[s.where];
  if (s.kind == SiteKind::edge) {
    const std::int32_t h = *topology_.sides(s.where).begin();
    const std::int32_t low = std::min(topology_.from(h), topology_.to(h)),
                       high = std::max(topology_.from(h), topology_.to(h));
    const double t = s.at * (1.0 / grid);
    return (1 - t) * p[low] + t * period_.nearest(p[high], p[low]);
  }
  const Triangle& t = asset_.triangles[s.where];
  const Vec3 w = weights_of(s.in_face);
  return w[0] * p[t[0]] + w[1] * period_.nearest(p[t[1]], p[t[0]]) +
         w[2] * period_.nearest(p[t[2]], p[t[0]]);
}

GridPoint SiteTable::in_face(std::int32_t site, std::int32_t face) const {
  const Site& s = sites_[site];
  for (int i = 0; i < 3; ++i) {
    const std::int32_t h = 3 * face + i;
    if (s.kind == SiteKind::place && topology_.from(h) == s.where) return on_grid_edge(i, 0);
    if (s.kind == SiteKind::edge && topology_.edge(h) == s.where) {
      return on_grid_edge(i, topology_.from(h) < topology_.to(h) ? s.at : grid - s.at);
    }
  }
  return s.in_face;
}

bool SiteTable::touches(std::int32_t site, std::int32_t face) const {
  const Site& s = sites_[site];
  if (s.kind == SiteKind::face) return s.where == face;
  for (std::int32_t h = 3 * face; h < 3 * face + 3; ++h) {
    if ((s.kind == SiteKind::place ? topology_.from(h) : topology_.edge(h)) == s.where) return true;
  }
  return false;
}

std::int32_t SiteTable::common_face(std::int32_t a, std::int32_t b) const {
  if (sites_[a].kind < sites_[b].kind) std::swap(a, b);  // the one with fewer faces
  std::int32_t common = -1;
  for_each_face(a, [&](std::int32_t f) {
    if (touches(b, f)) common = f;
    return common < 0;
  });
  return common;
}

}  // namespace craze
