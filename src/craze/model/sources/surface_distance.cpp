#include "craze/model/sources/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "craze/mesh/tangent_frame.h"

namespace craze {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// A change smaller than this, relatively, is not passed on: it keeps thin triangles, where rounding
// grows, from feeding each other for ever.
constexpr double least_gain = 1e-5;

// Vertices taken from the front between two looks at whether to go on.
constexpr std::size_t between_looks = 100'000;

// Where the source lies in the plane of a triangle j, k, i, seen from edge j → k: j at the origin,
// k on the positive first axis, i above it and the source below.
struct Unfolded {
  Vec2 source, apex;
  double edge;
  bool valid;  ///< the two distances make a triangle with the edge
};

Unfolded unfold(const Vec3& j, const Vec3& k, const Vec3& i, double dj, double dk) {
  Unfolded u;
  const Vec3 e = k - j, a = i - j;
  u.edge = e.norm();
  const double x = a.dot(e) / u.edge;
  u.apex = {x, std::sqrt(std::max(0.0, a.squaredNorm() - x * x))};
  const double sx = (dj * dj - dk * dk + u.edge * u.edge) / (2 * u.edge);
  const double sy2 = dj * dj - sx * sx;
  const double slack = 1e-9 * (dj * dj + u.edge * u.edge);
  u.valid = u.edge > 0 && sy2 >= -slack;
  u.source = {sx, -std::sqrt(std::max(0.0, sy2))};
  return u;
}

// The distance at i by way of the edge j k: straight from the unfolded source if that ray crosses
// the edge, else along a side.
double update(const Vec3& j, const Vec3& k, const Vec3& i, double dj, double dk) {
  const double along = std::min(dj + (i - j).norm(), dk + (i - k).norm());
  if (!std::isfinite(dj) || !std::isfinite(dk)) return along;
  const Unfolded u = unfold(j, k, i, dj, dk);
  if (!u.valid) return along;
  const Vec2 ray = u.apex - u.source;
  if (ray.y() <= 0) return along;
  const double crossing = u.source.x() - u.source.y() * ray.x() / ray.y();
  if (crossing < 0 || crossing > u.edge) return along;
  return std::min(along, ray.norm());
}

}  // namespace

SurfaceDistance surface_distance(const TriangleMesh& mesh, const PointOnSurface& source,
                                 const Context& context, double reach) {
  SurfaceDistance result;
  result.vertex.assign(mesh.vertex_count(), infinite);
  result.face.assign(mesh.face_count(), infinite);
  result.direction.assign(mesh.face_count(), Vec2::Zero());
  if (source.face < 0) return result;
  std::vector<double>& distance = result.vertex;

  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  const auto lower = [&](std::int32_t v, double d) {
    // No way is shorter.
    d = std::max(d, (mesh.position_near(v, source.position) - source.position).norm());
    if (d > reach || d >= distance[v] * (1 - least_gain)) return;
    distance[v] = d;
    front.emplace(d, v);
  };
  for (const std::int32_t v : mesh.triangle(source.face)) {
    lower(v, (mesh.position_near(v, source.position) - source.position).norm());
  }
  // Ends: a distance only falls, by a part of itself each time, and not below the straight one.
  for (std::size_t taken = 1; !front.empty(); ++taken) {
    if (taken % between_looks == 0) context.check();
    const double d = front.top().first;
    const std::int32_t v = front.top().second;
    front.pop();
    if (d > distance[v]) continue;
    const Vec3& p = mesh.position(v);
    mesh.for_each_outgoing(v, [&](std::int32_t h) {
      const std::int32_t a = mesh.to(h), b = mesh.from(TriangleMesh::prev(h));
      const Vec3 pa = mesh.position_near(a, p), pb = mesh.position_near(b, p);
      lower(a, update(p, pb, pa, d, distance[b]));
      lower(b, update(p, pa, pb, d, distance[a]));
      // v and a may see past the edge into the next face before b is known from anywhere else.
      const std::int32_t o = mesh.opposite(TriangleMesh::next(h));
      if (o < 0) return;
      const std::int32_t c = mesh.from(TriangleMesh::prev(o));
      lower(c, update(pa, pb, mesh.position_near(c, p), distance[a], distance[b]));
    });
  }

  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle& t = mesh.triangle(f);
    const Vec3 centroid = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
    Vec3 away = Vec3::Zero();
    if (f == source.face) {
      away = mesh.period().shortest(centroid - source.position);
    } else {
      double best = infinite;
      for (int k = 0; k < 3; ++k) {
        const std::int32_t j = t[k], l = t[(k + 1) % 3], i = t[(k + 2) % 3];
        if (!std::isfinite(distance[j]) || !std::isfinite(distance[l])) continue;
        const Vec3& origin = mesh.position(t[0]);
        const Vec3 pj = mesh.position_near(j, origin), pl = mesh.position_near(l, origin),
                   pi = mesh.position_near(i, origin);
        const Unfolded u = unfold(pj, pl, pi, distance[j], distance[l]);
        if (u.edge <= 0) continue;
        const double seen = (u.apex - u.source).norm();
        const double mismatch = std::abs(seen - std::min(distance[i], reach));
        if (!(mismatch < best)) continue;
        best = mismatch;
        const Vec3 x = (pl - pj) / u.edge;
        const Vec3 above = pi - pj;
        const Vec3 y = (above - above.dot(x) * x).stableNormalized();
        away = centroid - (pj + u.source.x() * x + u.source.y() * y);
      }
      if (best == infinite) continue;
    }
    result.face[f] = away.norm();
    const Mat32 frame = tangent_frame(mesh, f);
    const Vec2 flat(frame.col(0).dot(away), frame.col(1).dot(away));
    if (flat.norm() > 0) result.direction[f] = flat.normalized();
  }
  return result;
}

}  // namespace craze
