// [IO06] §3.4, Eq. 2.
#include "craze/model/failure/separation_tensor.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "craze/model/basis_matrix.h"
#include "model/states.h"

namespace craze {
namespace {

using test::field_of;
using test::mesh_of;
using test::no_cap;
using test::random_stress;

Mat3 m(const Vec3& a) {
  if (a.norm() == 0) return Mat3::Zero();
  return a * a.transpose() / a.norm();
}

/// Force of a part of the stress on one corner: −A E σ ∇λ with the (capped) β of the face.
Vec3 part_force(const TriangleMesh& mesh, std::int32_t f, int corner, const Mat2& sigma,
                double cap) {
  const Triangle& t = mesh.triangle(f);
  const Mat2 beta = cap_singular_values(
      basis_matrix(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])), cap);
  const Vec2 gradient = corner == 0 ? Vec2(-beta.row(0) - beta.row(1)) : Vec2(beta.row(corner - 1));
  return -mesh.area(f) * (tangent_frame(mesh, f) * (sigma * gradient));
}

/// Eq. 2 term by term, with general eigen-decompositions.
Mat3 equation_2(const TriangleMesh& mesh, const StressField& field, std::int32_t v) {
  Mat3 sum = Mat3::Zero();
  Vec3 all_tensile = Vec3::Zero(), all_compressive = Vec3::Zero();
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      if (mesh.triangle(f)[corner] != v) continue;
      const Mat32 frame = tangent_frame(mesh, f);
      const Mat2 sigma = frame.transpose() * field.stress(mesh, f).matrix() * frame;
      const Eigen::SelfAdjointEigenSolver<Mat2> solver(sigma);
      Mat2 positive = Mat2::Zero(), negative = Mat2::Zero();
      for (int i = 0; i < 2; ++i) {
        const Vec2 n = solver.eigenvectors().col(i);
        const double s = solver.eigenvalues()[i];
        (s > 0 ? positive : negative) += s * n * n.transpose();
      }
      const double cap = field.singular_value_cap();
      const Vec3 tensile = part_force(mesh, f, corner, positive, cap);
      const Vec3 compressive = part_force(mesh, f, corner, negative, cap);
      sum += m(tensile) - m(compressive);
      all_tensile += tensile;
      all_compressive += compressive;
    }
  }
  return 0.5 * (sum - m(all_tensile) + m(all_compressive));
}

struct State {
  std::string shape;
  double cap_factor;  // of the mesh's own cap; 0: none
};

std::vector<State> states() {
  return {{"plate?n=6&jitter=0.4", 0}, {"sphere?n=3", 0},   {"cube?n=2", 0},
          {"strip?n=2&length=40", 0},  {"torus?n=10", 0.6}, {"plate?n=5&jitter=0.45", 0.5}};
}

StressField stressed(const TriangleMesh& mesh, double cap_factor, std::uint64_t seed) {
  return field_of(mesh, random_stress(mesh, seed),
                  cap_factor > 0 ? cap_factor * singular_value_cap(mesh) : no_cap);
}

TEST(SeparationTensor, IsEquation2EvaluatedWithGeneralEigenDecompositions) {
  for (const State& state : states()) {
    const TriangleMesh mesh = mesh_of(state.shape);
    const StressField field = stressed(mesh, state.cap_factor, 11);
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      const Mat3 expected = equation_2(mesh, field, v);
      const Sym3 got = separation_tensor(mesh, field, v).tensor;
      EXPECT_LT((got.matrix() - expected).norm(), 1e-11 * (1 + expected.norm()))
          << state.shape << " node " << v;
    }
  }
}

TEST(SeparationTensor, NoEigenvalueExceedsTheBound) {
  for (const State& state : states()) {
    const TriangleMesh mesh = mesh_of(state.shape);
    for (const std::uint64_t seed : {12, 13, 14, 15}) {
      const StressField field = stressed(mesh, state.cap_factor, seed);
      for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
        const SeparationTensor separation = separation_tensor(mesh, field, v);
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(separation.tensor.matrix());
        EXPECT_LE(solver.eigenvalues()[2], separation.bound * (1 + 1e-12));
      }
    }
  }
}

TEST(SeparationTensor, TensileAndCompressivePartsAddUpToEquation1) {
  const TriangleMesh mesh = mesh_of("sphere?n=4");
  const StressField field = stressed(mesh, 0, 16);
  for (const Element& e : field.elements()) {
    for (int corner = 0; corner < 3; ++corner) {
      const SplitForce f = split_force(e, corner);
      EXPECT_LT((f.tensile + f.compressive - element_force(e, corner)).norm(), 1e-13);
    }
  }
}

TEST(SeparationTensor, PureTensionHasNoCompressivePartAndTheReverse) {
  const TriangleMesh mesh = mesh_of("plate?n=2");
  for (const double sign : {1.0, -1.0}) {
    const StressField field = field_of(mesh, {sign, 2 * sign, 0, 0.5 * sign, 0, 0});
    for (const Element& e : field.elements()) {
      const SplitForce f = split_force(e, 1);
      EXPECT_EQ((sign > 0 ? f.compressive : f.tensile), Vec3::Zero());
    }
  }
}

TEST(SeparationTensor, ACrackPlaneIsPerpendicularToTheTension) {
  // Uniaxial tension at an angle: the plane's normal is the direction of the pull.
  const TriangleMesh mesh = mesh_of("plate?n=12&jitter=0.2");
  for (const double angle : {0.0, 0.3, 1.0, 1.5, 2.4}) {
    const Vec3 pull(std::cos(angle), std::sin(angle), 0);
    Sym3 sigma;
    add_outer(sigma, 1, pull);
    const StressField field = field_of(mesh, sigma);
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.is_open_vertex(v)) continue;
      const Eigenpair pair = largest_eigenpair(separation_tensor(mesh, field, v).tensor);
      EXPECT_GT(pair.value, 0);
      EXPECT_GT(std::abs(pair.vector.dot(pull)), 1 - 1e-12);
    }
  }
}

TEST(SeparationTensor, PureCompressionOpensNothingInside) {
  const TriangleMesh mesh = mesh_of("plate?n=8&jitter=0.3");
  const StressField field = field_of(mesh, {-1, -2, 0, 0.1, 0, 0});
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_open_vertex(v)) continue;
    EXPECT_LT(largest_eigenpair(separation_tensor(mesh, field, v).tensor).value, 1e-14);
  }
}

TEST(SeparationTensor, TurnsWithTheSurface) {
  const SurfaceMesh s = make_shape("sphere?n=3");
  Random random(17);
  const Mat3 turn = Eigen::AngleAxisd(1.1, test::random_unit(random)).toRotationMatrix();
  std::vector<Vec3> moved;
  for (const Vec3& p : s.positions) moved.push_back(turn * p + Vec3(1, 2, 3));
  const TriangleMesh mesh(s.positions, s.triangles), other(moved, s.triangles);
  const std::vector<Sym3> stress = random_stress(mesh, 18);
  std::vector<Sym3> turned;
  for (const Sym3& t : stress) {
    const Mat3 w = turn * t.matrix() * turn.transpose();
    turned.push_back({w(0, 0), w(1, 1), w(2, 2), w(0, 1), w(1, 2), w(2, 0)});
  }
  const StressField here = field_of(mesh, stress), there = field_of(other, turned);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Mat3 a = separation_tensor(mesh, here, v).tensor.matrix();
    const Mat3 b = separation_tensor(other, there, v).tensor.matrix();
    EXPECT_LT((turn * a * turn.transpose() - b).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace craze
