#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "craze/products/statistics/plots/plots.h"
#include "craze/products/statistics/quantities.h"
#include "craze/products/statistics/statistics_report.h"

namespace craze {
namespace {

struct Measured {
  StatisticsWithSensitivity statistics =
      compute_with_sensitivity(null_graph(NullModel::poisson_voronoi, 200, 1));
  std::vector<NullRow> nulls = null_rows({}, 200);
};

TEST(Statistics, AreStoppedAtAnyMomentAndSayWhatTheyAre) {
  const CrackGraphInput graph = null_graph(NullModel::poisson_voronoi, 200, 1);
  int questions = 0, reports = 0;
  StatisticsOptions options;
  options.bootstrap.context.cancelled = [&] { return ++questions < 0; };
  options.bootstrap.context.progress = [&](const Progress& p) {
    ++reports;
    EXPECT_EQ(p.phase, "statistics");
  };
  compute_with_sensitivity(graph, options);
  EXPECT_GT(reports, 0);
  EXPECT_GT(questions, 1000);  // each resample of more than ten
  for (const int last : {1, questions / 2, questions}) {
    int asked = 0;
    options.bootstrap.context.cancelled = [&] { return ++asked >= last; };
    EXPECT_THROW(compute_with_sensitivity(graph, options), Cancelled);
  }
}

TEST(Report, EveryQuantityIsInTheJsonWithItsError) {
  const Measured m;
  const auto json = to_json(m.statistics, m.nulls);
  std::set<std::string_view> keys;
  for (const Quantity& q : quantities()) {
    EXPECT_TRUE(keys.insert(q.key).second) << q.key << " is there twice";
    std::string pointer = "/" + std::string(q.key);
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    const nlohmann::ordered_json::json_pointer at(pointer);
    ASSERT_TRUE(json.contains(at)) << q.key;
    EXPECT_TRUE(json[at].contains("value") && json[at].contains("error")) << q.key;
    EXPECT_TRUE(json["sensitivity"]["half"].contains(at)) << q.key;
    for (const char* model : {"voronoi", "orthogonal", "stit"}) {
      EXPECT_TRUE(json["null"][model].contains(at)) << q.key;
    }
  }
  EXPECT_TRUE(json["order"]["leg_younger"]["value"].is_null()) << "Voronoi cracks have no times";
  EXPECT_EQ(json["counts"]["cells"], m.statistics.result.cells);
  EXPECT_EQ(nlohmann::json::parse(json.dump()).dump().find("nan"), std::string::npos);
}

TEST(Report, EveryQuantityIsExplainedInTheDocs) {
  std::ifstream file(CRAZE_SOURCE_DIR "/docs/statistics.md");
  ASSERT_TRUE(file);
  std::stringstream docs;
  docs << file.rdbuf();
  for (const Quantity& q : quantities()) {
    EXPECT_NE(docs.str().find("`" + std::string(q.key) + "`"), std::string::npos) << q.key;
  }
}

TEST(Report, TheTableHasALinePerQuantityAndAColumnPerNullModel) {
  const Measured m;
  const std::string text = to_text(m.statistics, m.nulls);
  for (const Quantity& q : quantities()) EXPECT_NE(text.find(q.text), std::string::npos) << q.key;
  for (const char* model : {"voronoi", "orthogonal", "stit"}) {
    EXPECT_NE(text.find(model), std::string::npos);
  }
}

TEST(Report, TheSameInputGivesTheSameBytes) {
  const Measured a, b;
  EXPECT_EQ(to_json(a.statistics, a.nulls).dump(), to_json(b.statistics, b.nulls).dump());
}

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Plots, AHistogramHasABarPerFilledBinAndNoOther) {
  const std::string svg =
      histogram_svg({0.05, 0.05, 0.15, 0.95, 7}, {"title", "axis", 0, 1, 10, 0, 0.2, {0.5}});
  EXPECT_EQ(count(svg, "<rect"), 1 + 3);
  EXPECT_EQ(count(svg, "stroke-dasharray"), 1);
  EXPECT_EQ(count(svg, "nan"), 0);
  EXPECT_EQ(count(histogram_svg({}, {"title", "axis", 0, 1, 10, 0, 0.2, {}}), "<rect"), 1);
}

TEST(Plots, TheGraphShowsEveryLineAndJunction) {
  const CrackGraphInput graph = null_graph(NullModel::hexagonal, 100, 1);
  const Statistics s = compute_statistics(graph);
  const std::string by_time = graph_svg(graph, GraphColor::time);
  const std::string by_junction = graph_svg(graph, GraphColor::junction);
  EXPECT_EQ(count(by_time, "<line"), static_cast<int>(graph.edges.size()) + 40);
  EXPECT_EQ(count(by_junction, "<line"), static_cast<int>(graph.edges.size()));
  EXPECT_GT(count(by_junction, "<circle"), s.junctions);
  EXPECT_EQ(count(by_junction, "nan"), 0);
}

}  // namespace
}  // namespace craze
