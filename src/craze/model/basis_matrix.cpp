#include "craze/model/basis_matrix.h"

#include <algorithm>
#include <limits>

namespace craze {

Mat2 basis_matrix(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  // In the frame: p1 − p0 = (length, 0), p2 − p0 = (along, height).
  const Vec3 a = p1 - p0, b = p2 - p0;
  const double length = a.norm();
  const double along = a.dot(b) / length;
  const double height = a.cross(b).norm() / length;
  Mat2 beta;
  beta << 1 / length, -along / (length * height),  //
      0, 1 / height;
  return beta;
}

SingularValues singular_values(const Mat2& m) {
  const double p = m(0, 0) + m(1, 1), q = m(0, 1) - m(1, 0);
  const double r = m(0, 0) - m(1, 1), s = m(0, 1) + m(1, 0);
  const double sum = std::hypot(p, q), difference = std::hypot(r, s);
  return {0.5 * (sum + difference), 0.5 * std::abs(sum - difference)};
}

Mat2 cap_singular_values(const Mat2& beta, double cap) {
  const SingularValues s = singular_values(beta);
  if (!(s.largest > cap)) return beta;
  // β = U Σ Vᵀ. V's first column v is the eigenvector of βᵀβ for the largest value; scaling β
  // along v (and, if need be, across it) replaces Σ without ever forming U.
  const Mat2 c = beta.transpose() * beta;
  const double angle = 0.5 * std::atan2(2 * c(0, 1), c(0, 0) - c(1, 1));
  const Vec2 v(std::cos(angle), std::sin(angle)), w(-v.y(), v.x());
  const double along = cap / s.largest;
  const double across = s.smallest > cap ? cap / s.smallest : 1;
  return beta * (along * v * v.transpose() + across * w * w.transpose());
}

double singular_value_cap(const TriangleMesh& mesh) {
  std::vector<double> largest;
  largest.reserve(mesh.face_count());
  for (const Triangle& t : mesh.triangles()) {
    const Mat2 beta =
        basis_matrix(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
    const double s = singular_values(beta).largest;
    if (std::isfinite(s)) largest.push_back(s);
  }
  if (largest.empty()) return std::numeric_limits<double>::infinity();
  const auto quantile = largest.begin() + static_cast<std::ptrdiff_t>(0.95 * (largest.size() - 1));
  std::nth_element(largest.begin(), quantile, largest.end());
  return 1.5 * *quantile;
}

}  // namespace craze
