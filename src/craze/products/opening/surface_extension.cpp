#include "craze/products/opening/surface_extension.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <utility>

namespace craze {

namespace {

/// Cotangent of the angle opposite to h.
double cotangent(const TriangleMesh& mesh, std::int32_t h) {
  const std::int32_t apex = mesh.from(TriangleMesh::prev(h));
  const Vec3 a = mesh.way(apex, mesh.from(h)), b = mesh.way(apex, mesh.to(h));
  const double twice_area = a.cross(b).norm();
  return twice_area > 0 ? a.dot(b) / twice_area : 0;
}

/// The cotangent weight of the edge of h. Never negative, so that no value lies outside those of
/// the neighbours, and bounded, so that slivers do no harm.
double edge_weight(const TriangleMesh& mesh, std::int32_t h) {
  const double other = mesh.is_open(h) ? 0 : cotangent(mesh, mesh.opposite(h));
  return 0.5 * std::clamp(cotangent(mesh, h) + other, 0.0, 40.0);
}

}  // namespace

std::vector<double> extend_over_surface(const TriangleMesh& mesh,
                                        const std::vector<std::uint8_t>& is_known,
                                        const std::vector<double>& known, double length,
                                        double tolerance) {
  std::vector<std::int32_t> unknown(mesh.vertex_count(), -1);
  std::vector<double> values(mesh.vertex_count(), 0);
  std::int32_t unknowns = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (is_known[v]) {
      values[v] = known[v];
    } else {
      unknown[v] = unknowns++;
    }
  }
  if (unknowns == 0 || unknowns == mesh.vertex_count()) return values;

  // (M + ℓ² K) L = 0 with the lumped mass M and the weighted Laplacian K.
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(mesh.face_count()) * 15);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
  const double ll = length * length;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const std::int32_t a = mesh.from(h), b = mesh.to(h);
    const double mass = mesh.area(TriangleMesh::face_of(h)) / 3;
    if (unknown[a] >= 0) entries.emplace_back(unknown[a], unknown[a], mass);
    if (mesh.opposite(h) > h) continue;  // each edge once
    const double w = ll * edge_weight(mesh, h);
    for (const auto& [v, other] : {std::pair{a, b}, std::pair{b, a}}) {
      if (unknown[v] < 0) continue;
      entries.emplace_back(unknown[v], unknown[v], w);
      if (unknown[other] >= 0) {
        entries.emplace_back(unknown[v], unknown[other], -w);
      } else {
        right[unknown[v]] += w * values[other];
      }
    }
  }
  // A vertex without faces has nothing to take a value from.
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (unknown[v] >= 0 && mesh.first_halfedge(v) < 0) {
      entries.emplace_back(unknown[v], unknown[v], 1);
    }
  }
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(tolerance);
  solver.compute(matrix);
  const Eigen::VectorXd solution = solver.solve(right);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (unknown[v] >= 0) values[v] = solution[unknown[v]];
  }
  return values;
}

}  // namespace craze
