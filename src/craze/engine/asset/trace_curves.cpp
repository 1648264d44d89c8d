#include "craze/engine/asset/trace_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace craze {

namespace {

constexpr int most_steps = 20000;     // of one walk
constexpr double longest_way = 4;     // in lengths of the chord
constexpr double direct_way = 1.5;    // likewise: what is no longer does not lead astray
constexpr double least_slope = 0.05;  // sine between chord and normal: below, no plane is theirs
constexpr double straight_on = 0.5;   // cosine: less is not ahead

}  // namespace

CurveTracer::CurveTracer(const SurfaceMesh& asset, const AssetTopology& topology, SiteTable& sites,
                         double usual_chord)
    : asset_(asset),
      topology_(topology),
      sites_(sites),
      usual_chord_(usual_chord),
      shortest_way_(asset, topology, sites) {}

Vec3 CurveTracer::area_normal(std::int32_t face) const {
  const Triangle& t = asset_.triangles[face];
  const Vec3& p = asset_.positions[t[0]];
  return way(p, asset_.positions[t[1]]).cross(way(p, asset_.positions[t[2]]));
}

Vec3 CurveTracer::normal(std::int32_t site) const {
  Vec3 sum = Vec3::Zero();
  const bool is_edge = sites_[site].kind == SiteKind::edge;
  sites_.for_each_face(site, [&](std::int32_t f) {
    const Vec3 n = area_normal(f);
    sum += is_edge ? n.stableNormalized() : n;
    return true;
  });
  return sum.stableNormalized();
}

void CurveTracer::trace(std::int32_t from, std::int32_t to, std::int32_t curve_edge,
                        std::vector<CurvePiece>& pieces) {
  if (from == to) return;
  if (const std::int32_t f = sites_.common_face(from, to); f >= 0) {
    pieces.push_back({f, from, to, curve_edge});
    return;
  }
  const std::size_t before = pieces.size();
  const double chord = way(place_of(from), place_of(to)).norm();
  const Vec3 a = normal(from), b = normal(to);
  const double walked = walk(from, to, a + b, curve_edge, pieces);
  if (walked <= direct_way * chord) return;
  const double most = longest_way * std::max(chord, usual_chord_);
  SurfaceWay shortest;
  if (!sites_.period().is_given()) shortest = shortest_way_.find(from, to, std::min(walked, most));
  if (shortest.last_face >= 0) {
    pieces.resize(before);
    follow(shortest, from, to, curve_edge, pieces);
    ++report_.rerouted;
  } else if (std::isinf(walked)) {
    ++report_.lost;
    report_.lost_length += chord;
  }
}

void CurveTracer::follow(const SurfaceWay& way, std::int32_t from, std::int32_t to,
                         std::int32_t curve_edge, std::vector<CurvePiece>& pieces) {
  std::int32_t site = from;
  for (const Crossing& c : way.crossings) {
    const std::int32_t reached = sites_.on_halfedge(c.halfedge, c.share);
    if (reached != site) pieces.push_back({c.face, site, reached, curve_edge});
    site = reached;
  }
  if (site != to) pieces.push_back({way.last_face, site, to, curve_edge});
}

/// The length of the way, infinite where there is none; pieces are then as before.
double CurveTracer::walk(std::int32_t from, std::int32_t to, const Vec3& normal,
                         std::int32_t curve_edge, std::vector<CurvePiece>& pieces) {
  const std::size_t before = pieces.size();
  const Vec3 start = place_of(from), target = sites_.period().nearest(place_of(to), start);
  const double most = longest_way * (target - start).norm();
  double length = 0;
  const auto fail = [&] {
    pieces.resize(before);
    return std::numeric_limits<double>::infinity();
  };
  std::int32_t site = from, face = -1;
  Vec3 origin = start, across = Vec3::Zero();
  for (int step = 0; step < most_steps; ++step) {
    if (const std::int32_t f = sites_.common_face(site, to); f >= 0) {
      pieces.push_back({f, site, to, curve_edge});
      return length + way(place_of(site), target).norm();
    }
    if (step == 0 || sites_[site].kind == SiteKind::place) {  // a vertex may lie beside the plane
      origin = place_of(site);
      across = normal.stableNormalized().cross(way(origin, target).stableNormalized());
      if (across.norm() < least_slope) return fail();
    } else if (topology_.sides(sites_[site].where).size() != 2) {
      return fail();
    }
    const Step next = best_step(site, face, origin, across, target);
    if (next.face < 0) return fail();
    const std::int32_t reached = sites_.on_halfedge(next.halfedge, next.share);
    if (reached == site) return fail();
    length += way(place_of(site), place_of(reached)).norm();
    if (length > most) return fail();
    pieces.push_back({next.face, site, reached, curve_edge});
    site = reached;
    face = next.face;
  }
  return fail();
}

/// Where the plane through origin, perpendicular to `across`, leaves the faces that touch a site:
/// out of the one face after last_face if the site lies inside an edge, else most straight ahead.
CurveTracer::Step CurveTracer::best_step(std::int32_t site, std::int32_t last_face,
                                         const Vec3& origin, const Vec3& across,
                                         const Vec3& target) const {
  const Vec3 here = place_of(site), ahead_of = way(here, target).stableNormalized();
  const Site& s = sites_[site];
  Step best;
  Step along;  // to the corner most straight ahead, where the plane holds an edge
  sites_.for_each_face(site, [&](std::int32_t f) {
    if (f == last_face) return true;
    double height[3];
    for (int i = 0; i < 3; ++i) {
      height[i] = across.dot(way(origin, asset_.positions[topology_.from(3 * f + i)]));
    }
    for (int i = 0; i < 3; ++i) {
      const std::int32_t h = 3 * f + i;
      const double a = height[i], b = height[(i + 1) % 3];
      const Vec3 pa = sites_.period().nearest(asset_.positions[topology_.from(h)], here),
                 pb = sites_.period().nearest(asset_.positions[topology_.to(h)], pa);
      const double straight = ahead_of.dot((pa - here).stableNormalized());
      if (straight > along.ahead && pa != here) along = {f, h, 0, straight};
      const bool own = s.kind == SiteKind::place
                           ? topology_.from(h) == s.where || topology_.to(h) == s.where
                           : s.kind == SiteKind::edge && topology_.edge(h) == s.where;
      if (own || topology_.edge(h) < 0 || (a > 0) == (b > 0)) continue;
      const double share = a / (a - b);
      const Vec3 x = pa + share * (pb - pa);
      const double ahead = ahead_of.dot((x - here).stableNormalized());
      if (ahead > best.ahead) best = {f, h, share, ahead};
    }
    return true;
  });
  if (s.kind == SiteKind::edge && last_face >= 0 && best.face >= 0) return best;
  if (best.ahead > straight_on) return best;
  return along.ahead > straight_on ? along : Step();
}

}  // namespace craze
