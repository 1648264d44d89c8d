#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>

#include "craze/engine.h"
#include "craze/presets.h"
#include "craze/products.h"
#include "craze/shapes.h"
#include "error_message.h"
#include "recipe_with.h"

namespace craze {
namespace {

Result cracked(const std::vector<std::string>& settings) {
  Recipe recipe = read_preset("mud");
  recipe.simulation.layer.relative_spacing = 0.15;
  recipe = recipe_with(settings, recipe);
  auto plate = std::make_shared<SurfaceMesh>(make_shape("plate?n=30&jitter=0.3"));
  plate->metres_per_unit = 1;
  return crack({plate, {}, "plate"}, recipe, {}, {});
}

double length_of(const LineSet& lines, std::size_t e) {
  return (lines.points[lines.edges[e][1]] - lines.points[lines.edges[e][0]]).norm();
}

/// Of the lines as they would be opened by `gap`, over their length.
double mean_width(const LineSet& lines, double gap) {
  const std::vector<double>& width = find_attribute(lines.edge_attributes, "width")->values;
  double sum = 0, length = 0;
  for (std::size_t e = 0; e < lines.edges.size(); ++e) {
    sum += gap * width[e] * length_of(lines, e);
    length += length_of(lines, e);
  }
  return sum / length;
}

TEST(GapWidth, IsTheMeanOpeningOverTheCracksLength) {
  for (const auto& [text, width] : {std::pair{"2mm", 0.002}, {"0.004", 0.004}}) {
    const Result result = cracked({std::string("post.gap_width=") + text});
    const PostParameters& post = result.report().recipe.post;
    EXPECT_NEAR(mean_width(crack_lines(result), post.gap), width, 1e-12);
    EXPECT_EQ(post.gap_width, 0);  // so that the report's recipe says it once
  }
}

TEST(GapWidth, IsHowFarTheRimsOfCracksStandApart) {
  const Result result = cracked({"post.gap_width=0.002"});
  const Opening opening(result, result.report().recipe.post, {});
  const std::vector<Vec3> shut = cut_mesh(result, {}).positions;
  const std::vector<Vec3>& open = opening.mesh().positions;
  std::map<std::array<double, 2>, std::vector<std::size_t>> on_place;
  for (std::size_t v = 0; v < shut.size(); ++v) on_place[{shut[v].x(), shut[v].y()}].push_back(v);
  double sum = 0;
  int rims = 0;
  for (const auto& [place, vertices] : on_place) {
    if (vertices.size() != 2) continue;  // junctions have more
    sum += (open[vertices[0]] - open[vertices[1]]).norm();
    ++rims;
  }
  ASSERT_GT(rims, 100);
  EXPECT_NEAR(sum / rims, 0.002, 0.0002);
}

TEST(GapWidth, OpensAsTheGapDoesThatTheReportTells) {
  const Result by_width = cracked({"post.gap_width=0.003"});
  const PostParameters& post = by_width.report().recipe.post;
  const Result by_gap = cracked({"post.gap=" + std::to_string(post.gap)});
  const Opening a(by_width, post, {}), b(by_gap, by_gap.report().recipe.post, {});
  ASSERT_EQ(a.mesh().positions.size(), b.mesh().positions.size());
  for (std::size_t v = 0; v < a.mesh().positions.size(); ++v) {
    EXPECT_LT((a.mesh().positions[v] - b.mesh().positions[v]).norm(), 1e-6);
  }
}

TEST(GapWidth, ExcludesAGap) {
  const std::string message = error_of(
      [] {
        cracked({"post.gap_width=2mm", "post.gap=0.1"});
      },
      ErrorKind::usage);
  EXPECT_NE(message.find("post.gap_width"), std::string::npos) << message;
}

TEST(GapWidth, OpensNothingWhereNothingCracked) {
  const Result result = cracked({"post.gap_width=2mm", "evolution.max_load=0.1"});
  EXPECT_EQ(result.report().recipe.post.gap, 0);
}

}  // namespace
}  // namespace craze
