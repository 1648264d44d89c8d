#include "craze/products/growth/crack_schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "craze/engine/cracked_surface.h"
#include "craze/model/crack_network.h"
#include "craze/products/growth/growth_times.h"
#include "products/opening/real_runs.h"

namespace craze {
namespace {

struct Scheduled {
  Simulation simulation = test::cracked("plate?n=30&jitter=0.3");
  CrackNetwork network = crack_network(simulation);
  CrackSites sites = crack_sites(simulation.mesh());
  CrackSchedule schedule = crack_schedule(simulation.mesh(), sites, network);

  double arrival(std::int32_t node) const {
    return schedule.sites[sites.site_of[network.nodes[node].vertex]];
  }
  double length(const CrackEdge& e) const {
    return (network.nodes[e.b].position - network.nodes[e.a].position).norm();
  }
};

TEST(CrackSchedule, CracksRunAlongAllAtOneSpeedAndNeverPopUp) {
  const Scheduled s;
  const TriangleMesh& mesh = s.simulation.mesh();
  double slowest = std::numeric_limits<double>::infinity(), fastest = 0;
  for (std::size_t i = 0; i < s.sites.sides.size(); ++i) {
    if (s.sites.first[i] != s.sites.first[i + 1]) continue;
    const std::int32_t h = s.sites.sides[i];
    const double length = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
    const double took = std::abs(s.schedule.sides[i][1] - s.schedule.sides[i][0]);
    ASSERT_GT(took, 0) << "one end opens with the other";
    slowest = std::min(slowest, length / took);
    fastest = std::max(fastest, length / took);
  }
  EXPECT_NEAR(slowest, fastest, 1e-6 * fastest);
  EXPECT_GT(slowest * CrackSchedule::longest_run, 0.3) << "as long as a part of the plate";
}

/// The places from which cracks run: none beside them opens earlier.
int starts(double roughness, OutputMesh output) {
  Recipe recipe = read_preset("mud");
  recipe.mesh.output = output;
  recipe.simulation.layer.relative_spacing = 0.15;
  recipe.post.relative_roughness = roughness;
  Input input;
  input.surface = std::make_shared<const SurfaceMesh>(make_shape("plate?n=40&jitter=0.3"));
  const Result result = crack(std::move(input), recipe, {}, {});
  const CrackNetwork& network = result.state().network;
  const GrowthTimes times = growth_times(result);
  const auto arrival = [&](std::int32_t node) {
    return times.schedule.sites[times.sites.site_of[network.nodes[node].vertex]];
  };
  std::vector<bool> is_start(network.nodes.size(), true);
  for (const CrackEdge& e : network.edges) {
    if (arrival(e.a) < arrival(e.b)) is_start[e.b] = false;
    if (arrival(e.b) < arrival(e.a)) is_start[e.a] = false;
  }
  return static_cast<int>(std::count(is_start.begin(), is_start.end(), true));
}

TEST(CrackSchedule, RoughCracksRunFromWhereSmoothOnesRun) {
  for (const OutputMesh output : {OutputMesh::asset, OutputMesh::simulation}) {
    const int smooth = starts(0, output);
    EXPECT_GT(smooth, 5);
    EXPECT_LT(starts(0.06, output), 2 * smooth);
  }
}

TEST(CrackSchedule, TheLongestCrackTakesItsPartOfTheClip) {
  const Scheduled s;
  double first = 1, last = 0;
  for (const double t : s.schedule.sites) {
    first = std::min(first, t);
    last = std::max(last, t);
  }
  EXPECT_EQ(first, 0);
  EXPECT_LE(last, 1 - CrackSchedule::opening_time);
  EXPECT_GT(last, 1 - CrackSchedule::opening_time - CrackSchedule::longest_run);
}

TEST(CrackSchedule, CracksOfALaterLoadStartLater) {
  const Scheduled s;
  std::vector<std::pair<double, double>> starts;  // load, time
  std::vector<bool> reached(s.network.nodes.size(), false);
  for (const CrackEdge& e : s.network.edges) {
    if (!reached[e.a]) starts.emplace_back(e.time, s.arrival(e.a));
    reached[e.a] = reached[e.b] = true;
  }
  ASSERT_GT(starts.size(), 5u);
  EXPECT_LT(starts.front().first, starts.back().first);
  EXPECT_TRUE(std::is_sorted(starts.begin(), starts.end(),
                             [](const auto& x, const auto& y) { return x.second < y.second; }));
}

TEST(CrackSchedule, BothSidesOfACrackOpenTogether) {
  const Scheduled s;
  const TriangleMesh& mesh = s.simulation.mesh();
  std::map<std::array<std::int32_t, 2>, std::array<double, 2>> known;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < s.sites.sides.size(); ++i) {
    const std::int32_t h = s.sites.sides[i];
    known[{s.sites.site_of[mesh.from(h)], s.sites.site_of[mesh.to(h)]}] = s.schedule.sides[i];
  }
  for (const auto& [ends, times] : known) {
    const auto other = known.find({ends[1], ends[0]});
    if (other == known.end()) continue;
    ++pairs;
    EXPECT_EQ(times[0], other->second[1]);
    EXPECT_EQ(times[1], other->second[0]);
  }
  EXPECT_GT(pairs, 100u);
}

TEST(CrackSchedule, IsShutBeforeTheCrackComesAndOpenSoonAfter) {
  EXPECT_EQ(CrackSchedule::openness(0.3, 0.3), 0);
  EXPECT_GT(CrackSchedule::openness(0.3, 0.32), 0);
  EXPECT_EQ(CrackSchedule::openness(0.3, 0.3 + CrackSchedule::opening_time), 1);
}

}  // namespace
}  // namespace craze
