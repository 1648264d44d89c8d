// A rough scan cracks as if it were smooth: no stubs, and next to no free ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "craze/base/random.h"
#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/presets.h"
#include "craze/products/statistics/graph/graph_input.h"
#include "craze/products/statistics/statistics.h"
#include "craze/shapes.h"
#include "recipe_with.h"

namespace craze {
namespace {

/// A sphere whose upper part has noise of half an edge, vertex by vertex.
SurfaceMesh noisy_sphere() {
  SurfaceMesh sphere = make_shape("sphere?n=48");
  sphere.corner_normals.clear();
  const double edge =
      (sphere.positions[sphere.triangles[0][0]] - sphere.positions[sphere.triangles[0][1]]).norm();
  Random random(1);
  for (Vec3& p : sphere.positions) {
    const double rough = std::clamp((p.z() - 0.2) / 0.2, 0.0, 1.0);
    p *= 1 + 0.5 * edge * rough * random.normal();
  }
  return sphere;
}

Statistics cracked(const std::string& setting) {
  const auto scan = std::make_shared<const SurfaceMesh>(noisy_sphere());
  const Recipe recipe = recipe_with({"layer.relative_spacing=0.12", setting}, read_preset("glaze"));
  const Result result = crack({scan, {}, "scan"}, recipe, {}, {});
  StatisticsOptions options;
  options.bootstrap.resamples = 0;
  return compute_statistics(graph_from_network(result.state().network, result.state().mesh()),
                            options);
}

TEST(ARoughScan, HasNoStubsAndNextToNoFreeEndsWhereItsOwnTrianglesHadMany) {
  const Statistics own = cracked("mesh.edge=keep"), asset = cracked("mesh.output=asset");
  EXPECT_GT(own.dead_ends.value, 0.08) << "rough enough to tell";
  EXPECT_LE(asset.dead_ends.value, 0.02);
  EXPECT_LE(asset.spurs.value, 0.005);
  EXPECT_GT(asset.cells, 20);
}

}  // namespace
}  // namespace craze
