#include "craze/post/growth_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "craze/mesh/self_intersection.h"
#include "post/real_runs.h"

namespace craze {
namespace {

struct Opening {
  Simulation simulation;
  OpeningOptions options{.gap = 0.15, .wall = 0.02};
  CrackSites sites = crack_sites(simulation.mesh());
  CrackSchedule schedule = crack_schedule(simulation.mesh(), sites, simulation.network());
  OpenedMesh opened = open_cracks(simulation.mesh(), test::displacements(simulation), options);
  GrowthMotion motion{simulation.mesh(), sites, schedule, opened};

  explicit Opening(const std::string& shape) : simulation(test::cracked(shape)) {}
};

TEST(GrowthMotion, LeadsFromTheShutSurfaceToTheOpenedOne) {
  const Opening o("plate?n=30&jitter=0.3");
  const std::vector<Vec3> start = o.motion.positions(0), end = o.motion.positions(1);
  ASSERT_EQ(end.size(), o.opened.mesh.positions.size());
  for (std::size_t v = 0; v < end.size(); ++v) {
    const bool top = v < o.simulation.mesh().positions().size();
    EXPECT_LE((end[v] - o.opened.mesh.positions[v]).norm(), 1e-12);
    EXPECT_EQ(start[v], top ? o.simulation.mesh().positions()[v] : o.opened.mesh.positions[v]);
  }
}

TEST(GrowthMotion, AheadOfTheCrackItsSidesAreOne) {
  const Opening o("plate?n=30&jitter=0.3");
  const TriangleMesh& mesh = o.simulation.mesh();
  int ahead = 0, behind = 0;
  for (const double time : {0.1, 0.3, 0.5, 0.8}) {
    const std::vector<Vec3> p = o.motion.positions(time);
    for (std::size_t i = 0; i < o.sites.sides.size(); ++i) {
      const std::int32_t v = mesh.from(o.sites.sides[i]);
      const std::int32_t other = o.sites.vertex[o.sites.site_of[v]];
      if (o.schedule.sites[o.sites.site_of[v]] >= time) {
        EXPECT_EQ(p[v], mesh.position(v));
        ++ahead;
      } else if (v != other && p[v] != p[other]) {
        ++behind;
      }
    }
  }
  EXPECT_GT(ahead, 100);
  EXPECT_GT(behind, 100);
}

TEST(GrowthMotion, WhereALaterCrackWillStartTheEdgeOfThePieceIsStillWhole) {
  const Opening o("plate?n=30&jitter=0.3");
  const TriangleMesh& mesh = o.simulation.mesh();
  // Pairs of vertices at one site that a crack of a later time parts.
  int later = 0;
  for (std::size_t i = 0; i < o.sites.sides.size(); ++i) {
    const std::int32_t h = o.sites.sides[i], v = mesh.from(h);
    const std::int32_t site = o.sites.site_of[v];
    const double start = o.schedule.sides[i][0];
    if (start < o.schedule.sites[site] + 0.1) continue;
    const std::vector<Vec3> p = o.motion.positions(start);
    // The vertex across: the end of the side that comes back.
    for (const std::int32_t g : o.sites.sides) {
      if (mesh.to(g) == v || o.sites.site_of[mesh.to(g)] != site ||
          o.sites.site_of[mesh.from(g)] != o.sites.site_of[mesh.to(h)]) {
        continue;
      }
      EXPECT_LE((p[v] - p[mesh.to(g)]).norm(), 1e-12);
      EXPECT_GT((p[v] - mesh.position(v)).norm(), 0) << "the older crack is open there";
      ++later;
    }
  }
  EXPECT_GT(later, 10);
}

TEST(GrowthMotion, TheSurfaceHardlyPassesThroughItselfOnTheWay) {
  const Opening o("sphere?n=12");
  const auto& triangles = o.simulation.mesh().triangles();
  // Only the end is made free of crossings; walls of cracks that are still shut lie on each other.
  for (const double time : {0.15, 0.4, 0.7, 0.9}) {
    EXPECT_LE(self_intersections(o.motion.positions(time), triangles).size(),
              0.01 * static_cast<double>(triangles.size()))
        << time;
  }
  EXPECT_TRUE(self_intersections(o.motion.positions(1), o.opened.mesh.triangles).empty());
}

}  // namespace
}  // namespace craze
