// The equilibrium by a sparse Cholesky factorization of the whole mesh: what solvers are held to.
#pragma once

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <vector>

#include "craze/model/element_response.h"
#include "craze/model/stress_field.h"
#include "model/states.h"

namespace craze::test {

/// Two unit vectors that span the plane square to a unit normal.
inline Mat32 plane_of(const Vec3& normal) {
  const Vec3 axis = std::abs(normal.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
  Mat32 plane;
  plane.col(0) = normal.cross(axis).normalized();
  plane.col(1) = normal.cross(plane.col(0));
  return plane;
}

/// F − κ A u in the tangent planes, 2 #V; zero at fixed nodes.
inline Eigen::VectorXd tangential_residual(const TriangleMesh& mesh, const StressField& field,
                                           double kappa, const std::vector<char>& fixed = {}) {
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(2 * mesh.vertex_count());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (v < static_cast<std::int32_t>(fixed.size()) && fixed[v] != 0) continue;
    const Vec3 pull = field.force(v) - kappa * field.node_areas()[v] * field.displacement(v);
    residual.segment<2>(2 * v) = plane_of(field.normals()[v]).transpose() * pull;
  }
  return residual;
}

/// Displaces `field` into equilibrium, exactly but for rounding. Returns, per node, by how much its
/// forces changed (StressField::displace).
inline std::vector<double> solve_directly(StressField& field, const TriangleMesh& mesh,
                                          double kappa, const std::vector<char>& fixed = {}) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto is_fixed = [&](std::int32_t v) {
    return v < static_cast<std::int32_t>(fixed.size()) && fixed[v] != 0;
  };
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const double mass = is_fixed(v) ? 1 : kappa * field.node_areas()[v];
    for (int i = 0; i < 2; ++i) entries.emplace_back(2 * v + i, 2 * v + i, mass);
  }
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle& t = mesh.triangle(f);
    for (int b = 0; b < 3; ++b) {
      if (is_fixed(t[b])) continue;
      const Mat32 plane_b = plane_of(field.normals()[t[b]]);
      for (int j = 0; j < 2; ++j) {
        Vec4d::Lanes u[3] = {};
        for (int k = 0; k < 3; ++k) u[b][k] = plane_b(k, j);
        const ElementResponse answer =
            element_response(field.elements()[f], u[1] - u[0], u[2] - u[0]);
        const Vec4d::Lanes forces[3] = {-answer.f1 - answer.f2, answer.f1, answer.f2};
        for (int a = 0; a < 3; ++a) {
          if (is_fixed(t[a])) continue;
          const Vec3 force(forces[a][0], forces[a][1], forces[a][2]);
          const Eigen::Vector2d row = plane_of(field.normals()[t[a]]).transpose() * force;
          for (int i = 0; i < 2; ++i) entries.emplace_back(2 * t[a] + i, 2 * t[b] + j, row[i]);
        }
      }
    }
  }
  Eigen::SparseMatrix<double> stiffness(2 * mesh.vertex_count(), 2 * mesh.vertex_count());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(stiffness);
  const Eigen::VectorXd x = factors.solve(tangential_residual(mesh, field, kappa, fixed));

  std::vector<Vec4d> displacements(mesh.vertex_count());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3 u = plane_of(field.normals()[v]) * x.segment<2>(2 * v);
    displacements[v].v = Vec4d::Lanes{u.x(), u.y(), u.z(), 0};
    field.displacements()[v].v += displacements[v].v;
  }
  return displace_all(mesh, field, displacements);
}

}  // namespace craze::test
