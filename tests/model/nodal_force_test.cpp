// [IO06] §3.2, §3.3, Eq. 1.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>

#include "craze/model/basis_matrix.h"
#include "model/states.h"

namespace craze {
namespace {

using test::distance;
using test::field_of;
using test::mesh_of;
using test::random_stress;

/// Eq. 1 as it is printed: β 3×3, the inverse of [u; v; 1] of the corners in the plane's axes.
Vec3 equation_1(const Vec3 (&p)[3], const Mat32& axes, const Mat2& sigma, int i) {
  Mat3 corners;
  for (int j = 0; j < 3; ++j) {
    corners.col(j) << axes.transpose() * (p[j] - p[0]), 1;
  }
  const Mat3 beta = corners.inverse();
  const double area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
  Vec3 sum = Vec3::Zero();
  for (int j = 0; j < 3; ++j) {
    for (int k = 0; k < 2; ++k) {
      for (int l = 0; l < 2; ++l) sum += p[j] * beta(j, l) * beta(i, k) * sigma(k, l);
    }
  }
  return -area * sum;
}

Mat2 in_axes(const Sym3& s, const Mat32& axes) {
  return axes.transpose() * s.matrix() * axes;
}

Eigen::Isometry3d random_motion(std::uint64_t seed) {
  Random random(seed);
  return Eigen::Translation3d(3 * test::random_unit(random)) *
         Eigen::AngleAxisd(random.uniform(0, 6), test::random_unit(random));
}

TEST(NodalForce, IsEquation1EvaluatedLiterallyInAnyFrame) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p[3] = {test::random_unit(random), test::random_unit(random),
                       test::random_unit(random)};
    const TriangleMesh mesh({p[0], p[1], p[2]}, {{0, 1, 2}});
    const std::vector<Sym3> stress = random_stress(mesh, 100 + i);
    const StressField field = field_of(mesh, stress);
    const Mat32 frame = tangent_frame(mesh, 0);
    // Another orthonormal frame of the same plane.
    const Mat32 axes = frame * Eigen::Rotation2Dd(random.uniform(0, 6)).toRotationMatrix();
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3 force = element_force(field.elements()[0], corner);
      const double scale = 1e-10 * (1 + force.norm());
      EXPECT_LT((force - equation_1(p, frame, in_axes(stress[0], frame), corner)).norm(), scale);
      EXPECT_LT((force - equation_1(p, axes, in_axes(stress[0], axes), corner)).norm(), scale);
    }
  }
}

TEST(NodalForce, OfANodeIsTheSumOverItsStar) {
  const TriangleMesh mesh = mesh_of("torus?n=16");
  const StressField field = field_of(mesh, random_stress(mesh, 2));
  std::vector<Vec3> sum(mesh.vertex_count(), Vec3::Zero());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      sum[mesh.triangle(f)[i]] += element_force(field.elements()[f], i);
    }
  }
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_LT((field.force(v) - sum[v]).norm(), 1e-12);
  }
}

TEST(NodalForce, ForcesOfOneElementSumToZeroAndHaveNoMoment) {
  for (const std::string shape : {"sphere?n=3", "plate?n=6&jitter=0.4", "torus?n=12"}) {
    const TriangleMesh mesh = mesh_of(shape);
    const StressField field = field_of(mesh, random_stress(mesh, 3));
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
      for (int i = 0; i < 3; ++i) {
        const Vec3 force = element_force(field.elements()[f], i);
        sum += force;
        moment += mesh.position(mesh.triangle(f)[i]).cross(force);
      }
      EXPECT_LT(sum.norm(), 1e-13);
      EXPECT_LT(moment.norm(), 1e-13);
    }
  }
}

TEST(NodalForce, ZeroStressLeavesTheSurfaceInEquilibrium) {
  const TriangleMesh mesh = mesh_of("cup?n=24");
  StressField field = field_of(mesh, Sym3{});
  test::relax(mesh, field, {}, 10);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(field.force(v), Vec3::Zero());
    EXPECT_EQ(field.displacement(v), Vec3::Zero());
  }
}

TEST(NodalForce, UniformTensionOnAFlatPlatePullsOnlyAtItsBorderAndInward) {
  const TriangleMesh mesh = mesh_of("plate?n=10&jitter=0.4");
  const StressField field = field_of(mesh, {1, 1, 1, 0, 0, 0});
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_open_vertex(v)) {
      EXPECT_LT(field.force(v).dot(mesh.position(v)), 0);
    } else {
      EXPECT_LT(field.force(v).norm(), 1e-14);
    }
  }
}

TEST(NodalForce, AddedStressIsReadBackAndItsNormalPartIsDropped) {
  const TriangleMesh mesh = mesh_of("sphere?n=4");
  const Sym3 tensor{1, -2, 3, 0.5, -0.7, 0.2};
  StressField field(mesh, test::no_cap);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    field.add_stress(mesh, f, tensor);
    const Mat32 frame = tangent_frame(mesh, f);
    EXPECT_LT(distance(field.stress(mesh, f), to_world(to_frame(tensor, frame), frame)), 1e-12);
    field.add_stress(mesh, f, -1 * tensor);
    EXPECT_LT(field.stress(mesh, f).matrix().norm(), 1e-12);
  }
}

TEST(NodalForce, ACappedElementAlsoGivesBackTheStressThatWasAdded) {
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0.4, 0.001, 0}}, {{0, 1, 2}});
  const StressField field = field_of(mesh, {1, 2, 0, 0.3, 0, 0}, 4.0);
  EXPECT_LT(distance(field.stress(mesh, 0), {1, 2, 0, 0.3, 0, 0}), 1e-12);
}

TEST(NodalForce, ARigidMotionTurnsForceAndStressWithTheSurface) {
  const SurfaceMesh s = make_shape("torus?n=14");
  const Eigen::Isometry3d motion = random_motion(7);
  std::vector<Vec3> moved;
  for (const Vec3& p : s.positions) moved.push_back(motion * p);
  const TriangleMesh mesh(s.positions, s.triangles), other(moved, s.triangles);
  const std::vector<Sym3> stress = random_stress(mesh, 8);
  std::vector<Sym3> turned;
  for (const Sym3& t : stress) {
    const Mat3 m = motion.linear() * t.matrix() * motion.linear().transpose();
    turned.push_back({m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)});
  }
  StressField here = field_of(mesh, stress), there = field_of(other, turned);
  test::relax_one_by_one(mesh, here, {0.1, 5.0, 0}, 20);
  test::relax_one_by_one(other, there, {0.1, 5.0, 0}, 20);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_LT((motion.linear() * here.force(v) - there.force(v)).norm(), 1e-12);
    EXPECT_LT((motion.linear() * here.displacement(v) - there.displacement(v)).norm(), 1e-12);
  }
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Mat3 m = motion.linear() * here.stress(mesh, f).matrix() * motion.linear().transpose();
    EXPECT_LT((m - there.stress(other, f).matrix()).norm(), 1e-11);
  }
  // Steps taken at once are followed in single precision.
  test::relax(mesh, here, {0.1, 5.0, 0}, 20);
  test::relax(other, there, {0.1, 5.0, 0}, 20);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_LT((motion.linear() * here.force(v) - there.force(v)).norm(), 1e-6);
  }
}

TEST(NodalForce, TheOrderOfATrianglesCornersChangesNothing) {
  const SurfaceMesh s = make_shape("sphere?n=5");
  std::vector<Triangle> turned = s.triangles;
  for (std::size_t f = 0; f < turned.size(); ++f) {
    std::rotate(turned[f].begin(), turned[f].begin() + f % 3, turned[f].end());
  }
  const TriangleMesh mesh(s.positions, s.triangles), other(s.positions, turned);
  const std::vector<Sym3> stress = random_stress(mesh, 9);
  const double cap = singular_value_cap(mesh) / 2;  // low: every element is capped
  StressField here = field_of(mesh, stress, cap), there = field_of(other, stress, cap);
  test::relax_one_by_one(mesh, here, {}, 20);
  test::relax_one_by_one(other, there, {}, 20);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_LT((here.force(v) - there.force(v)).norm(), 1e-12);
  }
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_LT(distance(here.stress(mesh, f), there.stress(other, f)), 1e-11);
  }
}

TEST(NodalForce, NodeAreasAddUpToTheSurface) {
  const TriangleMesh mesh = mesh_of("cup?n=24");
  const StressField field(mesh, test::no_cap);
  double sum = 0;
  for (const double a : field.node_areas()) sum += a;
  EXPECT_NEAR(sum / mesh.total_area(), 1, 1e-12);
}

}  // namespace
}  // namespace craze
