// post.late_width: cracks that have been open for longer are wider.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>

#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/engine/width_by_age.h"
#include "craze/maps.h"
#include "craze/mesh/self_intersection.h"
#include "craze/presets.h"
#include "craze/products.h"
#include "craze/shapes.h"

namespace craze {
namespace {

Result cracked(const std::string& shape, const char* preset, double gap_width,
               double late_width = 1) {
  Recipe recipe = read_preset(preset);
  recipe.mesh.edge.kind = EdgeLength::Kind::keep;
  recipe.simulation.layer.relative_spacing = 0.15;
  recipe.post.gap_width = gap_width;
  recipe.post.late_width = late_width;
  return crack({std::make_shared<SurfaceMesh>(make_shape(shape)), {}, shape}, recipe, {}, {});
}

WidthByAge ages(const Result& result, double late) {
  return width_by_age(late, result.state().network.edges);
}

/// By crack label: how far the middles of its two sides have parted; of cracks whose sides are one
/// edge each.
std::map<std::int32_t, double> partings(const Result& result, const PostParameters& post) {
  const TriangleMesh& mesh = result.state().mesh();
  const std::vector<Vec3> at = Opening(result, post, {}).mesh().positions;
  std::map<std::int32_t, std::vector<Vec3>> middles;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.crack_of(h) < 0) continue;
    middles[mesh.crack_of(h)].push_back((at[mesh.from(h)] + at[mesh.to(h)]) / 2);
  }
  std::map<std::int32_t, double> apart;
  for (const auto& [label, both] : middles) {
    if (both.size() == 2) apart[label] = (both[0] - both[1]).norm();
  }
  return apart;
}

TEST(WidthByAge, GoesFromOneAtTheFirstCrackToItselfAtTheLast) {
  WidthByAge width(0.25);
  for (const double time : {2.0, 1.0, 3.0}) width.add(time);
  EXPECT_EQ(width.factor(1), 1);
  EXPECT_EQ(width.factor(2), 0.625);
  EXPECT_EQ(width.factor(3), 0.25);
  WidthByAge one(0.25);
  one.add(5);
  EXPECT_EQ(one.factor(5), 1);
}

TEST(LateWidth, PartsTheSidesOfACrackByItsAge) {
  const Result result = cracked("plate?n=24&jitter=0.3", "mud", 0.0005);
  PostParameters post = result.report().recipe.post;
  const std::map<std::int32_t, double> alike = partings(result, post);
  post.late_width = 0.25;
  const std::map<std::int32_t, double> aged = partings(result, post);
  const WidthByAge by_age = ages(result, 0.25);
  double asked = 0, got = 0, largest_error = 0, full = 0;
  for (const auto& [label, apart] : alike) {
    const double wanted = by_age.factor(result.state().network.edges[label].time) * apart;
    asked += wanted;
    got += aged.at(label);
    full += apart;
    largest_error += std::abs(aged.at(label) - wanted);
  }
  EXPECT_GT(alike.size(), 100u);
  EXPECT_LT(asked, 0.9 * full);  // there are old and young ones
  EXPECT_NEAR(got / asked, 1, 0.03);
  EXPECT_LT(largest_error / asked, 0.08);
}

TEST(LateWidth, OfOneChangesNothing) {
  const Result result = cracked("plate?n=16&jitter=0.3", "glaze", 0.003);
  PostParameters post = result.report().recipe.post;
  const SurfaceMesh before = Opening(result, post, {}).mesh();
  post.late_width = 1;
  EXPECT_EQ(Opening(result, post, {}).mesh().positions, before.positions);
}

TEST(LateWidth, KeepsTheMeanThatGapWidthAsksFor) {
  const Result result = cracked("plate?n=24&jitter=0.3", "mud", 0.004, 0.3);
  const CrackNetwork& network = result.state().network;
  const WidthByAge by_age = ages(result, 0.3);
  double opening = 0;
  for (const CrackEdge& e : network.edges) {
    opening +=
        result.report().recipe.post.gap * e.width * by_age.factor(e.time) * network.length(e);
  }
  EXPECT_NEAR(opening / total_length(network), 0.004, 1e-9);
}

TEST(LateWidth, NeverMakesASurfacePassThroughItself) {
  for (const char* const shape : {"plate?n=20&jitter=0.3", "cup?n=24", "sphere?n=14"}) {
    for (const double late : {0.0, 0.3}) {
      const Result result = cracked(shape, "glaze", 0.01, late);
      for (const double curl : {0.0, 1.0}) {
        PostParameters post = result.report().recipe.post;
        post.wall = 0.02;
        post.curl = curl;
        const SurfaceMesh mesh = Opening(result, post, {}).mesh();
        EXPECT_TRUE(self_intersections(mesh.positions, mesh.triangles).empty())
            << shape << " " << late << " " << curl;
      }
    }
  }
}

TEST(LateWidth, MakesTheGroovesOfMapsNarrowerByTheSame) {
  const Result result = cracked("plate?n=16&jitter=0.3", "mud", 0.004);
  const WidthByAge by_age = ages(result, 0.25);
  MapOptions options;
  options.size = 128;
  options.maps = {MapKind::width, MapKind::time};
  options.post = result.report().recipe.post;
  std::vector<std::string> warnings;
  const std::vector<Map> alike = baked_maps(result, options, warnings, {});
  options.post.late_width = 0.25;
  const std::vector<Map> aged = baked_maps(result, options, warnings, {});
  double error = 0, sum = 0, least = 1;
  for (std::size_t i = 0; i < alike[0].values.size(); ++i) {
    const double factor = by_age.factor(alike[1].values[i]);
    const double wanted = factor * alike[0].values[i];
    least = std::min(least, factor);
    error += std::abs(aged[0].values[i] - wanted);
    sum += wanted;
  }
  EXPECT_LT(least, 0.5);
  EXPECT_LT(error / sum, 0.02);  // where a crack goes on as a younger one it narrows over an edge
}

}  // namespace
}  // namespace craze
