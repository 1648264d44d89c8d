#include "craze/model/normal_cycle.h"

#include <algorithm>
#include <cmath>

namespace craze {

namespace {

// ∫ w over the segment a → b, given relative to the ball's centre. With t measured along the line
// from the point nearest to the centre, at distance d, w = ((R² − d² − t²)/R²)².
double weight_on_segment(const Vec3& a, const Vec3& b, double radius) {
  const double length = (b - a).norm();
  if (length == 0) return 0;
  const Vec3 e = (b - a) / length;
  const double ta = a.dot(e), tb = ta + length;
  const double m2 = radius * radius - (a - ta * e).squaredNorm();
  if (m2 <= 0) return 0;
  const double m = std::sqrt(m2), low = std::max(ta, -m), high = std::min(tb, m);
  if (low >= high) return 0;
  const auto primitive = [m2](double t) {
    const double t2 = t * t;
    return t * (m2 * m2 - t2 * (2.0 / 3 * m2 - t2 / 5));
  };
  const double r2 = radius * radius;
  return (primitive(high) - primitive(low)) / (r2 * r2);
}

// ∫ w over a triangle, given relative to the ball's centre; n is its unit normal. Green's theorem
// around the centre's foot in the plane, at height z: with m² = R² − z² and r the distance from the
// foot, w = ((m² − r²)/R²)² = G'(r)/r, and ∫ w dA = Σ_edges ∫ G(r) dθ. Along an edge at signed
// distance D from the foot, dθ = D dt/r²; beyond r = m, G is constant.
double weight_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& n,
                          double radius) {
  const double z = a.dot(n), m2 = radius * radius - z * z;
  if (m2 <= 0) return 0;
  const double full = m2 * m2 * m2 / 6;
  double sum = 0;
  const auto add_edge = [&](const Vec3& p, const Vec3& q) {
    const double length = (q - p).norm();
    if (length == 0) return;
    const Vec3 e = (q - p) / length;
    const double tp = p.dot(e), tq = tp + length;
    const double d = p.cross(e).dot(n), d2 = d * d;
    const auto turn = [&](double s, double t) {
      if (t > s && d != 0) sum += full * std::atan2(d * (t - s), d2 + s * t);
    };
    if (d2 >= m2) return turn(tp, tq);
    const double k = std::sqrt(m2 - d2), low = std::max(tp, -k), high = std::min(tq, k);
    if (low >= high) return turn(tp, tq);
    const double c0 = 0.5 * m2 * (m2 - d2) + d2 * d2 / 6, c1 = (d2 / 3 - 0.5 * m2) / 3;
    const auto primitive = [&](double t) {
      const double t2 = t * t;
      return t * (c0 + t2 * (c1 + t2 / 30));
    };
    sum += d * (primitive(high) - primitive(low));
    turn(tp, low);
    turn(high, tq);
  };
  add_edge(a, b);
  add_edge(b, c);
  add_edge(c, a);
  const double r2 = radius * radius;
  return std::max(0.0, sum / (r2 * r2));
}

}  // namespace

NormalCycle::NormalCycle(const TriangleMesh& mesh) : mesh_(mesh) {
  const std::int32_t faces = mesh.face_count();
  normals_.resize(faces);
  angles_.assign(3 * static_cast<std::size_t>(faces), 0.0);
  for (std::int32_t f = 0; f < faces; ++f) {
    const Triangle& t = mesh.triangle(f);
    const Vec3& p = mesh.position(t[0]);
    normals_[f] = (mesh.position(t[1]) - p).cross(mesh.position(t[2]) - p).stableNormalized();
  }
  for (std::int32_t h = 0; h < 3 * faces; ++h) {
    if (mesh.is_open(h)) continue;
    const Vec3 e = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).stableNormalized();
    const Vec3& n = normals_[TriangleMesh::face_of(h)];
    const Vec3& o = normals_[TriangleMesh::face_of(mesh.opposite(h))];
    if (n.isZero() || o.isZero()) continue;
    angles_[h] = 0.5 * std::atan2(n.cross(o).dot(e), n.dot(o));
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
  for (std::size_t i = 0; i < scratch.queue.size(); ++i) {
    const std::int32_t f = scratch.queue[i];
    const Triangle& t = mesh_.triangle(f);
    const Vec3 p[3] = {mesh_.position(t[0]) - center, mesh_.position(t[1]) - center,
                       mesh_.position(t[2]) - center};
    const double area = weight_on_triangle(p[0], p[1], p[2], normals_[f], radius);
    result.area += area;
    result.normal += area * normals_[f];
    for (int k = 0; k < 3; ++k) {
      const std::int32_t o = mesh_.opposite(3 * f + k);
      if (o < 0) continue;
      const Vec3 &a = p[k], &b = p[(k + 1) % 3];
      const double length = weight_on_segment(a, b, radius);
      if (length == 0) continue;
      add_outer(result.tensor, angles_[3 * f + k] * length, (b - a).normalized());
      meet(TriangleMesh::face_of(o));
    }
  }
  return result;
}

}  // namespace craze
