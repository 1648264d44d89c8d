#include "craze/model/sources/normal_cycle.h"

#include <algorithm>
#include <cmath>

#include "craze/base/elementary.h"

namespace craze {

namespace {

// A side of a triangle relative to the ball's centre: the line it lies on, parametrised by length
// from the point nearest to the centre, and where the side begins and ends on it.
struct Side {
  double begin, end;
  double distance2;  ///< of the line from the centre, squared
};

Side side(const Vec3& from, const Vec3& unit, double length) {
  const double begin = from.dot(unit);
  return {begin, begin + length, std::max(0.0, from.squaredNorm() - begin * begin)};
}

// R⁴ ∫ w along a side: R⁴ w = (m² − t²)² with m² = R² − distance².
double weight_along(const Side& s, double radius2) {
  const double m2 = radius2 - s.distance2;
  if (m2 <= 0) return 0;
  const double m = std::sqrt(m2), low = std::max(s.begin, -m), high = std::min(s.end, m);
  if (low >= high) return 0;
  const auto primitive = [m2](double t) {
    const double t2 = t * t;
    return t * (m2 * m2 - t2 * (2.0 / 3 * m2 - t2 / 5));
  };
  return primitive(high) - primitive(low);
}

// One side's part of R⁴ ∫ w over its triangle. Green's theorem around the centre's foot in the
// triangle's plane, at height z: with m² = R² − z² and r the distance from the foot, R⁴ w =
// (m² − r²)² = G'(r)/r, and R⁴ ∫ w dA = Σ_sides ∫ G(r) dθ. Along a side at signed distance D from
// the foot, dθ = D dt/r²; beyond r = m, G is constant.
double weight_swept(const Side& s, double d, double m2) {
  const double d2 = d * d, full = m2 * m2 * m2 / 6;
  const auto turn = [&](double t0, double t1) {
    return t1 > t0 && d != 0 ? full * elementary::atan2(d * (t1 - t0), d2 + t0 * t1) : 0.0;
  };
  if (d2 >= m2) return turn(s.begin, s.end);
  const double k = std::sqrt(m2 - d2), low = std::max(s.begin, -k), high = std::min(s.end, k);
  if (low >= high) return turn(s.begin, s.end);
  const double c0 = 0.5 * m2 * (m2 - d2) + d2 * d2 / 6, c1 = (d2 / 3 - 0.5 * m2) / 3;
  const auto primitive = [&](double t) {
    const double t2 = t * t;
    return t * (c0 + t2 * (c1 + t2 / 30));
  };
  return d * (primitive(high) - primitive(low)) + turn(s.begin, low) + turn(high, s.end);
}

}  // namespace

NormalCycle::NormalCycle(const TriangleMesh& mesh) : mesh_(mesh) {
  const std::int32_t faces = mesh.face_count();
  normals_.resize(faces);
  edges_.resize(3 * static_cast<std::size_t>(faces));
  for (std::int32_t f = 0; f < faces; ++f) {
    const Triangle& t = mesh.triangle(f);
    normals_[f] = mesh.way(t[0], t[1]).cross(mesh.way(t[0], t[2])).stableNormalized();
  }
  for (std::int32_t h = 0; h < 3 * faces; ++h) {
    const Vec3 along = mesh.way(mesh.from(h), mesh.to(h));
    Edge& e = edges_[h];
    e.unit = along.stableNormalized();
    e.length = along.norm();
    if (mesh.is_open(h)) continue;
    const Vec3& n = normals_[TriangleMesh::face_of(h)];
    const Vec3& o = normals_[TriangleMesh::face_of(mesh.opposite(h))];
    if (n.isZero() || o.isZero()) continue;
    e.half_angle = 0.5 * elementary::atan2(n.cross(o).dot(e.unit), n.dot(o));
  }
}

CurvatureMeasure NormalCycle::measure(const Vec3& center, double radius,
                                      std::span<const std::int32_t> seeds, Scratch& scratch) const {
  CurvatureMeasure result;
  scratch.stamp.resize(mesh_.face_count(), 0);
  scratch.queue.clear();
  ++scratch.walk;
  const auto meet = [&](std::int32_t f) {
    if (scratch.stamp[f] == scratch.walk) return;
    scratch.stamp[f] = scratch.walk;
    scratch.queue.push_back(f);
  };
  for (const std::int32_t f : seeds) meet(f);
  const double radius2 = radius * radius, scale = 1 / (radius2 * radius2);
  for (std::size_t i = 0; i < scratch.queue.size(); ++i) {
    const std::int32_t f = scratch.queue[i];
    const Vec3& n = normals_[f];
    double swept = 0;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t h = 3 * f + k, o = mesh_.opposite(h);
      const Edge& e = edges_[h];
      const Vec3 from = mesh_.position_near(mesh_.from(h), center) - center;
      const Side s = side(from, e.unit, e.length);
      const double height = from.dot(n), m2 = radius2 - height * height;
      if (m2 > 0) swept += weight_swept(s, from.cross(e.unit).dot(n), m2);
      if (o < 0) continue;
      const double along = weight_along(s, radius2);
      if (along <= 0) continue;
      add_outer(result.tensor, e.half_angle * along * scale, e.unit);
      meet(TriangleMesh::face_of(o));
    }
    const double area = std::max(0.0, swept * scale);
    result.area += area;
    result.normal += area * n;
  }
  return result;
}

}  // namespace craze
