// Thousands of random curves on every kind of mesh, and what must hold of each cut.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/mesh/validate.h"
#include "engine/asset_cases.h"
#include "engine/cut_checks.h"

namespace craze {
namespace {

struct Case {
  std::string name;
  SurfaceMesh asset;
  bool manifold = true;  ///< TriangleMesh takes it
  double detour = 8;     ///< of a chain, in chords: ways are four at most, meeting points apart
};

Case shape(const std::string& name) {
  return {name, make_shape(name)};
}

std::vector<Case> open_meshes() {
  std::vector<Case> cases{shape("plate?n=1"), shape("plate?n=8&jitter=0.4"), shape("disc?n=12"),
                          shape("strip?n=1&length=40&width=0.1")};
  for (Case& c : cases) c.detour = 1.001;
  cases.push_back(shape("cylinder?n=12&open=1"));
  cases.push_back(shape("drape?n=24"));
  return cases;
}

std::vector<Case> closed_meshes() {
  return {shape("cube?n=1"),   shape("cube?n=4"),  shape("sphere?n=4"),
          shape("torus?n=16"), shape("bumps?n=6"), shape("cylinder?n=12")};
}

void cut_and_check(const Case& c, std::uint64_t seed, const test::RandomCurves& kind, double snap) {
  SCOPED_TRACE(c.name + " seed " + std::to_string(seed));
  Random random(seed);
  const SurfaceMesh asset = test::dressed(c.asset);
  const CrackCurves curves = test::random_curves(asset, random, kind);
  const CutAsset cut = test::cut(asset, curves, {snap});
  test::check_cut(asset, cut);
  test::check_attributes(asset, cut);
  EXPECT_EQ(cut.report.lost_segments, 0);
  if (cut.report.traced.lost == 0) {
    test::check_chains(curves, cut, c.detour, 1e-5 * test::diagonal(asset) + 8 * snap);
  }
  if (c.manifold) {
    const auto faults = validate(TriangleMesh(cut.positions, cut.triangles));
    EXPECT_TRUE(faults.empty()) << faults.front();
  }
}

TEST(RandomCurves, OnOpenMeshesAreCutAndNothingElse) {
  for (const Case& c : open_meshes()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) cut_and_check(c, seed, {}, 0);
    for (std::uint64_t seed = 0; seed < 5; ++seed) cut_and_check(c, seed, {}, 0.01);
  }
}

TEST(RandomCurves, OnClosedMeshesAreCutAndNothingElse) {
  for (const Case& c : closed_meshes()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) cut_and_check(c, seed, {}, 0);
    for (std::uint64_t seed = 0; seed < 5; ++seed) cut_and_check(c, seed, {}, 0.01);
  }
}

TEST(RandomCurves, OnThinAndNeedleMeshesAreCutAndNothingElse) {
  const std::vector<Case> cases{
      shape("bowl?n=16&wall=0.02"),
      {"flat box", test::needles(make_shape("cube?n=3"), 1e-3)},
      {"needles", test::needles(make_shape("plate?n=6&jitter=0.3"), 1e-6)},
      {"needles of a millionth of a millionth", test::needles(make_shape("plate?n=3"), 1e-12)}};
  for (const Case& c : cases) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) cut_and_check(c, seed, {}, 0);
    for (std::uint64_t seed = 0; seed < 5; ++seed) cut_and_check(c, seed, {}, 0.01);
  }
}

TEST(RandomCurves, OnMeshesOfHighGenusAndNonManifoldOnesAreCutAndNothingElse) {
  const std::vector<Case> cases{{"sponge", test::sponge()},
                                {"touching cubes", test::touching_cubes(), false}};
  for (const Case& c : cases) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) cut_and_check(c, seed, {}, 0);
  }
}

TEST(RandomCurves, OnMeshesWithSplitVerticesCrossTheSeams) {
  for (const std::string name : {"cube?n=2", "sphere?n=3", "plate?n=4&jitter=0.3"}) {
    const Case c{name, test::unwelded(make_shape(name))};
    for (std::uint64_t seed = 0; seed < 20; ++seed) cut_and_check(c, seed, {}, 0);
  }
}

TEST(RandomCurves, FarFromTheOriginLeaveNoFaceTurnedOver) {
  for (const double far : {1e4, 1e6, 1e8}) {
    for (const std::string name : {"plate?n=4&jitter=0.3", "sphere?n=3"}) {
      const Case c{name, test::moved(make_shape(name), {far, -3 * far, far / 7})};
      for (std::uint64_t seed = 0; seed < 15; ++seed) cut_and_check(c, seed, {}, 0);
    }
  }
}

TEST(RandomCurves, ByTheHundredCrossEachOtherInAFewLargeFaces) {
  for (const std::string name : {"plate?n=1", "cube?n=1"}) {
    Case c = shape(name);
    if (name[0] == 'p') c.detour = 1.001;
    for (std::uint64_t seed = 0; seed < 6; ++seed) cut_and_check(c, seed, {20, 10, 1}, 0);
    cut_and_check(c, 7, {40, 10, 1}, 0.003);
  }
}

RC_GTEST_PROP(RandomCurves, AreCutAndNothingElseWhateverTheSeed, (std::uint64_t seed)) {
  std::vector<Case> cases = open_meshes();
  for (const Case& c : closed_meshes()) cases.push_back(c);
  const auto which = *rc::gen::inRange<std::size_t>(0, cases.size());
  const auto chains = *rc::gen::inRange(1, 12), length = *rc::gen::inRange(1, 12),
             stride = *rc::gen::inRange(0, 6), snap = *rc::gen::inRange(0, 3);
  cut_and_check(cases[which], seed, {chains, length, stride}, snap * 0.01);
  RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace
}  // namespace craze
