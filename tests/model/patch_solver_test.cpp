#include "craze/model/relaxation/patch_solver.h"

#include <gtest/gtest.h>

#include "model/direct_solve.h"

namespace craze {
namespace {

/// A plate with a random stress in every face: nothing is in equilibrium.
class PatchSolverTest : public ::testing::Test {
 protected:
  static constexpr double kappa = 1 / (0.2 * 0.2), tolerance = 1e-5;

  PatchSolverTest() : stiffness_(kappa) { stiffness_.assemble(mesh_, field_); }

  void seed(std::int32_t v, std::int32_t patch) {
    seed_patch_[v] = patch;
    seeds_.resize(std::max(seeds_.size(), static_cast<std::size_t>(patch) + 1));
    seeds_[patch].push_back(v);
  }

  /// Every patch solved from the same state, and all their displacements added to it.
  void solve() {
    const LayerState layer{mesh_, field_, stiffness_, kappa, tolerance};
    std::vector<Vec4d> sum(mesh_.vertex_count());
    for (std::size_t i = 0; i < seeds_.size(); ++i) {
      PatchSolver solver;
      solver.solve(layer, seeds_[i], static_cast<std::int32_t>(i), seeds_.size() == 1, seed_patch_,
                   mark_);
      const PatchAnswer& answer = solver.answer();
      for (std::int32_t k = 0; k < answer.active; ++k) {
        const Vec3 u = answer.displacement(layer, k);
        sum[answer.nodes[k]].v += Vec4d::Lanes{u.x(), u.y(), u.z(), 0};
      }
    }
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) field_.displacements()[v].v += sum[v].v;
    test::displace_all(mesh_, field_, sum);
  }

  TriangleMesh mesh_ = test::mesh_of("plate?n=24&jitter=0.3");
  StressField field_ = test::field_of(mesh_, test::random_stress(mesh_, 3));
  TangentStiffness stiffness_;
  std::vector<std::vector<std::int32_t>> seeds_;  // by patch
  std::vector<std::int32_t> seed_patch_ = std::vector<std::int32_t>(mesh_.vertex_count(), -1);
  std::vector<std::int32_t> mark_ = seed_patch_;
};

TEST_F(PatchSolverTest, OnePatchTakesUpEveryResidualThatItReaches) {
  seed(mesh_.vertex_count() / 2, 0);
  solve();
  const Eigen::VectorXd residual = test::tangential_residual(mesh_, field_, kappa);
  for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
    EXPECT_LE(residual.segment<2>(2 * v).norm(), tolerance) << v;
  }
}

TEST_F(PatchSolverTest, PatchesThatOverlapTakeUpTheResidualsOfTheirSeedsAndNoOthers) {
  constexpr std::int32_t patches = 5;
  for (std::int32_t v = 0; v < mesh_.vertex_count(); v += 7) seed(v, v % patches);
  const Eigen::VectorXd before = test::tangential_residual(mesh_, field_, kappa);
  solve();
  const Eigen::VectorXd after = test::tangential_residual(mesh_, field_, kappa);
  for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
    const Eigen::Vector2d left =
        seed_patch_[v] >= 0 ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(before.segment<2>(2 * v));
    EXPECT_LE((after.segment<2>(2 * v) - left).norm(), patches * tolerance) << v;
    EXPECT_GT(before.segment<2>(2 * v).norm(), 100 * tolerance) << v;
  }
}

}  // namespace
}  // namespace craze
