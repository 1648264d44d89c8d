// [IO06] §4.1, Eqs. 3–7, and the energy that the relaxation descends.
#include "craze/model/relaxation/euler_relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "craze/base/symmetric_eigen.h"
#include "craze/model/basis_matrix.h"
#include "craze/model/cutting/crack_insertion.h"
#include "craze/model/failure/separation_tensor.h"
#include "model/states.h"

namespace craze {
namespace {

using test::energy;
using test::field_of;
using test::mesh_of;
using test::no_cap;
using test::random_stress;

/// Green's strain of Eqs. 4 and 5 for displaced corners, in the frame of the triangle at rest.
Mat2 greens_strain(const Mat3& corners, const Mat2& beta) {
  Mat32 edges;
  edges << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0);
  const Mat32 gradient = edges * beta;
  return 0.5 * (gradient.transpose() * gradient - Mat2::Identity());
}

TEST(EulerRelaxation, ChangesStressByTheDerivativeOfGreensStrainEquations4To7) {
  Random random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const Vec3 p[3] = {test::random_unit(random), test::random_unit(random),
                       test::random_unit(random)};
    const TriangleMesh mesh({p[0], p[1], p[2]}, {{0, 1, 2}});
    const Mat32 frame = tangent_frame(mesh, 0);
    const Mat2 beta = basis_matrix(p[0], p[1], p[2]);
    for (int node = 0; node < 3; ++node) {
      for (int axis = 0; axis < 3; ++axis) {
        // A unit move of one node along one axis, in a time so short that the step is taken whole:
        // Δσ is one column of ∂ε/∂p, Eq. 6.
        constexpr double time_step = 0x1p-30;
        StressField field(mesh, no_cap);
        field.forces()[node][axis] = 1 / time_step;
        test::relax(mesh, field, {time_step, 0, 0}, 1);
        const Sym2 got = to_frame(field.stress(mesh, 0), frame);

        const double h = 1e-6;
        Mat3 plus, minus;
        plus << p[0], p[1], p[2];
        minus = plus;
        plus(axis, node) += h;
        minus(axis, node) -= h;
        const Mat2 expected = (greens_strain(plus, beta) - greens_strain(minus, beta)) / (2 * h);
        const double scale = 1e-7 * (1 + beta.norm());
        EXPECT_NEAR(got.xx, expected(0, 0), scale);
        EXPECT_NEAR(got.yy, expected(1, 1), scale);
        EXPECT_NEAR(got.xy, expected(0, 1), scale);
      }
    }
  }
}

TEST(EulerRelaxation, MovesEveryNodeByTimeStepTimesForceEquation3) {
  const TriangleMesh mesh = mesh_of("sphere?n=4");
  StressField field = field_of(mesh, random_stress(mesh, 2));
  const StressField before = field;
  test::relax(mesh, field, {0.07, 0, 0}, 1);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_LT((field.displacement(v) - 0.07 * before.force(v)).norm(), 1e-14);
  }
}

TEST(EulerRelaxation, LeavesForcesInStepWithStress) {
  const TriangleMesh mesh = mesh_of("torus?n=20");
  StressField field = field_of(mesh, random_stress(mesh, 3));
  test::relax(mesh, field, {0.1, 3.0, 0}, 200);
  StressField fresh = field;
  fresh.update_forces(mesh);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_LT((field.force(v) - fresh.force(v)).norm(), 1e-12);
  }
}

TEST(EulerRelaxation, StressIsALinearFunctionOfTheVirtualDisplacement) {
  // σ = σ₀ + B u: walked to in many steps or in one, of the same end, σ is the same.
  const TriangleMesh mesh = mesh_of("sphere?n=4");
  const std::vector<Sym3> stress = random_stress(mesh, 4);
  StressField walked = field_of(mesh, stress);
  test::relax(mesh, walked, {0.05, 2.0, 0}, 40);
  StressField jumped = field_of(mesh, stress);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    jumped.forces()[v].v = 16.0 * walked.displacements()[v].v;
  }
  test::relax(mesh, jumped, {0.0625, 0, 0}, 1);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_LT(test::distance(walked.stress(mesh, f), jumped.stress(mesh, f)), 1e-11);
  }
}

void expect_energy_never_rises(const std::string& shape, double adhesion, double cap_factor) {
  const TriangleMesh mesh = mesh_of(shape);
  for (const std::uint64_t seed : {5, 6}) {
    StressField field =
        field_of(mesh, random_stress(mesh, seed), cap_factor * singular_value_cap(mesh));
    const double start = energy(mesh, field, adhesion);
    double last = start;
    for (int step = 0; step < 60; ++step) {
      test::relax(mesh, field, {0.1, adhesion, 0}, 1);
      const double now = energy(mesh, field, adhesion);
      ASSERT_LE(now, last * (1 + 1e-13)) << shape << ", step " << step;
      last = now;
    }
    EXPECT_LT(last, 0.9 * start) << shape;
  }
}

TEST(EulerRelaxation, EnergyNeverRisesWithoutAdhesion) {
  for (const std::string shape : {"plate?n=8&jitter=0.3", "sphere?n=4", "torus?n=14"}) {
    expect_energy_never_rises(shape, 0, 1);
    expect_energy_never_rises(shape, 0, 0.5);
  }
}

TEST(EulerRelaxation, EnergyNeverRisesWithAdhesion) {
  for (const std::string shape : {"plate?n=8&jitter=0.3", "sphere?n=4", "torus?n=14"}) {
    expect_energy_never_rises(shape, 30, 1);
  }
}

TEST(EulerRelaxation, AFreeFlatSheetRelaxesToZeroStress) {
  const TriangleMesh mesh = mesh_of("plate?n=6&jitter=0.3");
  StressField field = field_of(mesh, {1, 1, 0, 0, 0, 0});
  test::relax(mesh, field, {0.2, 0, 0}, 4000);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_LT(field.stress(mesh, f).matrix().norm(), 1e-6);
  }
}

TEST(EulerRelaxation, AFixedBorderHoldsUniformTension) {
  const TriangleMesh mesh = mesh_of("plate?n=6&jitter=0.3");
  std::vector<char> fixed(mesh.vertex_count());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) fixed[v] = mesh.is_open_vertex(v);
  StressField field = field_of(mesh, {1, 1, 0, 0, 0, 0});
  test::relax(mesh, field, {0.2, 0, 0}, 500, fixed);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_LT(test::distance(field.stress(mesh, f), {1, 1, 0, 0, 0, 0}), 1e-12);
  }
}

TEST(EulerRelaxation, FixedNodesAccumulateNoDisplacementWhateverPullsOnThem) {
  const TriangleMesh mesh = mesh_of("cylinder?n=16&open=1");
  std::vector<char> fixed(mesh.vertex_count());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) fixed[v] = mesh.is_open_vertex(v);
  StressField field = field_of(mesh, random_stress(mesh, 8));
  test::relax(mesh, field, {0.1, 0, 0}, 50, fixed);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (fixed[v]) {
      EXPECT_EQ(field.displacement(v), Vec3::Zero());
    } else {
      EXPECT_NE(field.displacement(v), Vec3::Zero());
    }
  }
}

// A plate with one row of slivers: a row of vertices was pushed almost onto the next.
TriangleMesh slivers() {
  SurfaceMesh s = make_shape("plate?n=24");
  for (Vec3& p : s.positions) {
    if (std::lround((p.y() + 0.5) * 24) == 10) p.y() += 0.997 / 24;
  }
  return {std::move(s.positions), std::move(s.triangles)};
}

TEST(EulerRelaxation, SliversNeedManyStableStepsWithoutTheSingularValueCapAndOneWithIt) {
  const TriangleMesh mesh = slivers();
  const std::vector<Sym3> stress = random_stress(mesh, 9);
  StressField wild = field_of(mesh, stress);
  StressField tame = field_of(mesh, stress, singular_value_cap(mesh));
  const double start = energy(mesh, tame, 0);
  EXPECT_GT(EulerRelaxation(mesh, wild, {0.1, 0, 0}).parts_of_a_step(), 20);
  EXPECT_EQ(EulerRelaxation(mesh, tame, {0.1, 0, 0}).parts_of_a_step(), 1);
  const double wild_start = energy(mesh, wild, 0);
  test::relax(mesh, wild, {0.1, 0, 0}, 60);
  EXPECT_LT(energy(mesh, wild, 0), wild_start);
  test::relax(mesh, tame, {0.1, 0, 0}, 60);
  EXPECT_LT(energy(mesh, tame, 0), start);
  const double later = energy(mesh, tame, 0);
  test::relax(mesh, tame, {0.1, 0, 0}, 1000);
  EXPECT_LT(energy(mesh, tame, 0), later);
}

TEST(EulerRelaxation, AtRestNothingIsTouchedAndNothingIsSaidToHaveChanged) {
  const TriangleMesh mesh = mesh_of("plate?n=60");
  std::vector<Sym3> stress(mesh.face_count());
  stress[mesh.face_count() / 2] = {1, 0, 0, 0, 0, 0};
  StressField field = field_of(mesh, stress);
  const StressField before = field;
  EulerRelaxation relaxation(mesh, field, {0.1, 0, 1e-6});
  relaxation.run(field, mesh, 10, 1);
  EXPECT_GT(relaxation.element_updates(), 0);
  EXPECT_LE(relaxation.element_updates(), 10 * mesh.face_count() / 2);
  std::vector<std::int32_t> drifted;
  relaxation.drifted(drifted);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (field.force(v) == before.force(v)) continue;
    EXPECT_TRUE(std::binary_search(drifted.begin(), drifted.end(), v));
  }
  EXPECT_LT(drifted.size(), static_cast<std::size_t>(mesh.vertex_count() / 2));
}

TEST(EulerRelaxation, ARunOfManyStepsIsAsManyRunsOfOneToSinglePrecision) {
  const TriangleMesh mesh = mesh_of("torus?n=30");
  const std::vector<Sym3> stress = random_stress(mesh, 11);
  for (const double adhesion : {0.0, 20.0}) {
    StressField at_once = field_of(mesh, stress), one_by_one = at_once;
    test::relax(mesh, at_once, {0.1, adhesion, 0}, 150);
    test::relax_one_by_one(mesh, one_by_one, {0.1, adhesion, 0}, 150);
    double moved = 0, apart = 0;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      moved = std::max(moved, one_by_one.displacement(v).norm());
      apart = std::max(apart, (at_once.displacement(v) - one_by_one.displacement(v)).norm());
    }
    EXPECT_LT(apart, 1e-6 * moved) << "adhesion " << adhesion;
  }
}

TEST(EulerRelaxation, TakesTooLongAStepAsTheFewestStableOnesOverTheSameTime) {
  const TriangleMesh mesh = mesh_of("plate?n=12&jitter=0.3");
  const std::vector<Sym3> stress = random_stress(mesh, 14);
  for (const double adhesion : {0.0, 1e4}) {
    StressField split = field_of(mesh, stress), fine = split;
    StiffnessBound bound(adhesion);
    bound.update(mesh, split);
    for (const double steps : {0.7, 1.3, 5.2}) {  // in the longest that is known to be stable
      const double dt = steps * 2 / bound.value();
      EulerRelaxation relaxation(mesh, split, {dt, adhesion, 0});
      const double parts = relaxation.parts_of_a_step();
      EXPECT_EQ(parts, std::ceil(steps));
      const double before = energy(mesh, split, adhesion);
      relaxation.run(split, mesh, 3, 1);
      EXPECT_LE(energy(mesh, split, adhesion), before);
      test::relax(mesh, fine, {dt / parts, adhesion, 0}, 3 * static_cast<std::int64_t>(parts));
    }
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_LT((split.displacement(v) - fine.displacement(v)).norm(), 1e-5);
    }
  }
}

TEST(EulerRelaxation, KeepsUpWithWhatCracksMakeOfTheMesh) {
  const TriangleMesh start = mesh_of("plate?n=20&jitter=0.3");
  CrackedSheet sheet = test::sheet_of(start, random_stress(start, 13), singular_value_cap(start));
  const TriangleMesh& mesh = sheet.mesh();
  StressField& field = sheet.field();
  EulerRelaxation at_once(mesh, field, {0.05, 0, 0}), one_by_one(mesh, field, {0.05, 0, 0});
  Random random(5);
  CrackOutcome outcome;
  for (int i = 0; i < 60; ++i) {
    const CrackRules rules{0.436, 0.262, i % 2 == 0 ? NearVertex::snap : NearVertex::slide};
    const auto v = static_cast<std::int32_t>(random.below(mesh.vertex_count()));
    open_crack(sheet, v, test::random_unit(random), rules, i, outcome);
    at_once.mesh_changed(mesh, field, outcome.changed_faces, outcome.changed_nodes);
    one_by_one.mesh_changed(mesh, field, outcome.changed_faces, outcome.changed_nodes);
  }
  StressField other = field;
  at_once.run(field, mesh, 20, 1);
  for (int step = 0; step < 20; ++step) one_by_one.run(other, mesh, 1, 1);
  double moved = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    moved = std::max(moved, other.displacement(v).norm());
  }
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_LT((field.displacement(v) - other.displacement(v)).norm(), 1e-6 * moved);
  }
}

// What has drifted less than it was allowed has no eigenvalue of ς changed by more.
TEST(EulerRelaxation, NoEigenvalueOfTheSeparationTensorChangesByMoreThanTheDrift) {
  const TriangleMesh mesh = mesh_of("sphere?n=8");
  StressField field = field_of(mesh, random_stress(mesh, 12));
  const StressField before = field;
  EulerRelaxation relaxation(mesh, field, {0.1, 0, 0});
  constexpr double allowed = 0.3;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) relaxation.allow_drift(v, allowed);
  relaxation.run(field, mesh, 3, 1);
  std::vector<std::int32_t> drifted;
  relaxation.drifted(drifted);
  const auto largest = [&](const StressField& f, std::int32_t v) {
    return largest_eigenpair(separation_tensor(mesh, f, v).tensor).value;
  };
  int quiet = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (std::binary_search(drifted.begin(), drifted.end(), v)) continue;
    ++quiet;
    EXPECT_LE(std::abs(largest(field, v) - largest(before, v)), allowed);
  }
  EXPECT_GT(quiet, 0);
  EXPECT_FALSE(drifted.empty());
}

TEST(EulerRelaxation, GivesTheSameBytesOnAnyNumberOfThreads) {
  const TriangleMesh mesh = mesh_of("plate?n=60&jitter=0.3");
  const std::vector<Sym3> stress = random_stress(mesh, 10);
  for (const std::int64_t steps : {1, 20}) {
    StressField reference = field_of(mesh, stress);
    test::relax(mesh, reference, {0.1, 100, 0}, steps);
    for (const int threads : {2, 3, 0}) {
      StressField field = field_of(mesh, stress);
      test::relax(mesh, field, {0.1, 100, 0}, steps, {}, threads);
      EXPECT_TRUE(test::same_bytes(field, reference));
    }
  }
}

}  // namespace
}  // namespace craze
