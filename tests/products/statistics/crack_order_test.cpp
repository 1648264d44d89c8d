#include "craze/products/statistics/measures/crack_order.h"

#include <gtest/gtest.h>

#include <cmath>

#include "craze/base/random.h"
#include "craze/products/statistics/null_models/null_models.h"
#include "craze/products/statistics/statistics.h"

namespace craze {
namespace {

TEST(CrackOrder, SequentialSplittingIsSeenAsSequential) {
  for (const NullModel model : {NullModel::orthogonal_splitting, NullModel::stit}) {
    const Statistics s = compute_statistics(null_graph(model, 800, 3));
    EXPECT_GE(s.leg_younger.value, 0.995) << to_string(model);
    EXPECT_GE(s.kendall_tau.value, 0.99) << to_string(model);
  }
}

TEST(CrackOrder, TheSameCracksRunBackwardsAreSeenAsBackwards) {
  CrackGraphInput graph = null_graph(NullModel::stit, 800, 3);
  for (GraphInputEdge& e : graph.edges) {
    e.time = 1000 - e.time;
    e.event = 1000 - e.event;
  }
  const Statistics s = compute_statistics(graph);
  EXPECT_LE(s.leg_younger.value, 0.005);
  EXPECT_LE(s.kendall_tau.value, -0.99);
}

TEST(CrackOrder, TimesAtRandomAreInNoOrder) {
  CrackGraphInput graph = null_graph(NullModel::stit, 3000, 3);
  const Random random(5);
  for (GraphInputEdge& e : graph.edges) e.time = random.uniform_at(e.event + 1);  // per crack
  const Statistics s = compute_statistics(graph);
  EXPECT_NEAR(s.leg_younger.value, 0.5, 0.05);
  EXPECT_NEAR(s.kendall_tau.value, 0, 0.25);
}

TEST(CrackOrder, EventsDecideWhereCracksShareALoad) {
  CrackGraphInput graph = null_graph(NullModel::stit, 300, 3);
  for (GraphInputEdge& e : graph.edges) e.time = 1;
  EXPECT_GE(compute_statistics(graph).leg_younger.value, 0.99);
}

TEST(CrackOrder, WithoutTimesNothingIsClaimed) {
  CrackGraphInput graph = null_graph(NullModel::stit, 300, 3);
  for (GraphInputEdge& e : graph.edges) {
    e.time = std::nan("");
    e.event = -1;
  }
  const Statistics s = compute_statistics(graph);
  EXPECT_TRUE(std::isnan(s.leg_younger.value));
  EXPECT_TRUE(std::isnan(s.kendall_tau.value));
}

}  // namespace
}  // namespace craze
