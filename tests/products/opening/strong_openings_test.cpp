// Openings far wider than there is room for: pieces that have shrunk, not torn ones.
#include <gtest/gtest.h>

#include "craze/products/opening/opening.h"
#include "products/opening/real_runs.h"

namespace craze {
namespace {

/// How far each open vertex has gone, as a part of what was asked.
std::vector<double> shares(const TriangleMesh& mesh, const std::vector<Vec3>& u, double gap,
                           const OpenedMesh& opened) {
  std::vector<double> share(mesh.positions().size(), 1);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const double asked = gap * u[v].norm();
    if (asked > 0) share[v] = (opened.mesh.positions[v] - mesh.position(v)).norm() / asked;
  }
  return share;
}

/// The part of the crack edges along which the share changes by more than half.
double jumps(const TriangleMesh& mesh, const std::vector<double>& share) {
  int all = 0, wide = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (!mesh.is_open(h) || mesh.crack_of(h) < 0) continue;
    const double a = share[mesh.from(h)], b = share[mesh.to(h)];
    ++all;
    wide += std::max(a, b) > 1.5 * std::min(a, b) ? 1 : 0;
  }
  return all > 0 ? wide / static_cast<double>(all) : 0;
}

/// The outline of a piece turns on itself where a rim's edge runs against what it was.
int reversed_rims(const TriangleMesh& mesh, const OpenedMesh& opened) {
  int reversed = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (!mesh.is_open(h)) continue;
    const Vec3 before = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
    const Vec3 after = opened.mesh.positions[mesh.to(h)] - opened.mesh.positions[mesh.from(h)];
    reversed += before.dot(after) < 0 ? 1 : 0;
  }
  return reversed;
}

class StrongOpenings : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(StrongOpenings, TaperSmoothlyAndTurnNoRim) {
  const auto& [shape, gap] = GetParam();
  const Simulation simulation = test::cracked(shape);
  const TriangleMesh& mesh = simulation.mesh();
  const std::vector<Vec3> u = test::displacements(simulation);
  const OpenedMesh opened = open_cracks(mesh, u, {.gap = gap}, {});
  EXPECT_EQ(opened.crossings + opened.folded_faces, 0);
  EXPECT_LT(jumps(mesh, shares(mesh, u, gap, opened)), 0.02);
  EXPECT_EQ(reversed_rims(mesh, opened), 0);
}

INSTANTIATE_TEST_SUITE_P(Post, StrongOpenings,
                         testing::Values(std::pair{"plate?n=40&jitter=0.3", 1.0},
                                         std::pair{"plate?n=40&jitter=0.3", 3.0},
                                         std::pair{"sphere?n=12", 3.0}, std::pair{"cup", 1.0}));

}  // namespace
}  // namespace craze
