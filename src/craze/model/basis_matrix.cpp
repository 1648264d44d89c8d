#include "craze/model/basis_matrix.h"

#include <algorithm>
#include <limits>

#include "craze/base/elementary.h"

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

namespace {

// GᵀG of the 3×2 gradients G, whose first row is minus the sum of β's.
Mat2 gram(const Mat2& beta) {
  const Vec2 first = beta.row(0) + beta.row(1);
  return beta.transpose() * beta + first * first.transpose();
}

}  // namespace

SingularValues singular_values(const Mat2& beta) {
  const Mat2 c = gram(beta);
  const double mean = 0.5 * (c(0, 0) + c(1, 1));
  const double radius = elementary::hypot(0.5 * (c(0, 0) - c(1, 1)), c(0, 1));
  const double largest = std::sqrt(mean + radius);
  // det GᵀG = 3 (det β)², which keeps the digits that mean − radius would lose.
  const double product = std::sqrt(3.0) * std::abs(beta.determinant());
  return {largest, largest > 0 ? product / largest : 0};
}

Mat2 cap_singular_values(const Mat2& beta, double cap) {
  const SingularValues s = singular_values(beta);
  if (!(s.largest > cap)) return beta;
  // G = U Σ Vᵀ. V's first column v is the eigenvector of GᵀG for the largest value; scaling β
  // along v (and, if need be, across it) replaces Σ without ever forming U.
  const Mat2 c = gram(beta);
  const double angle = 0.5 * elementary::atan2(2 * c(0, 1), c(0, 0) - c(1, 1));
  const Vec2 v(elementary::cos(angle), elementary::sin(angle)), w(-v.y(), v.x());
  const double along = cap / s.largest;
  const double across = s.smallest > cap ? cap / s.smallest : 1;
  return beta * (along * v * v.transpose() + across * w * w.transpose());
}

double singular_value_cap(const TriangleMesh& mesh) {
  std::vector<double> largest;
  largest.reserve(mesh.face_count());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Mat2 beta = basis_matrix(mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2));
    const double s = singular_values(beta).largest;
    if (std::isfinite(s)) largest.push_back(s);
  }
  if (largest.empty()) return std::numeric_limits<double>::infinity();
  const auto quantile = largest.begin() + static_cast<std::ptrdiff_t>(0.95 * (largest.size() - 1));
  std::nth_element(largest.begin(), quantile, largest.end());
  return 1.5 * *quantile;
}

}  // namespace craze
