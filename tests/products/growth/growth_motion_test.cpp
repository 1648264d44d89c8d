#include "craze/products/growth/growth_motion.h"
#include "craze/model/crack_network.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "craze/mesh/bounding_diagonal.h"
#include "craze/mesh/self_intersection.h"
#include "products/opening/real_runs.h"

namespace craze {
namespace {

struct Opening {
  Simulation simulation;
  OpeningOptions options{.gap = 0.05,
                         .wall = 0.008 * bounding_diagonal(simulation.mesh().positions())};
  CrackSites sites = crack_sites(simulation.mesh());
  CrackSchedule schedule = crack_schedule(simulation.mesh(), sites, crack_network(simulation));
  OpenedMesh opened = open_cracks(simulation.mesh(), test::displacements(simulation), options, {});
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
    EXPECT_TRUE(!top || start[v] == o.simulation.mesh().positions()[v]);
  }
}

TEST(GrowthMotion, AWallGoesDownAsItsCrackOpensAndABordersIsThereFromTheStart) {
  const Opening o("plate?n=30&jitter=0.3");
  const TriangleMesh& mesh = o.simulation.mesh();
  const std::vector<Vec3> start = o.motion.positions(0), half = o.motion.positions(0.5);
  int shut = 0, open = 0, border = 0;
  for (std::size_t b = mesh.positions().size(); b < start.size(); ++b) {
    const std::int32_t top = o.opened.vertex_of[b];
    const double x = std::max(std::abs(mesh.position(top).x()), std::abs(mesh.position(top).y()));
    if (x > 0.5 - 1e-9) {
      EXPECT_EQ(start[b], o.opened.mesh.positions[b]);
      ++border;
      continue;
    }
    EXPECT_EQ(start[b], mesh.position(top));
    const double arrival = o.schedule.sites[o.sites.site_of[top]];
    if (arrival > 0.5) {
      EXPECT_EQ(half[b], half[top]) << "no wall where there is no crack yet";
      ++shut;
    } else if (arrival + CrackSchedule::opening_time < 0.5) {
      EXPECT_LE((half[b] - o.opened.mesh.positions[b]).norm(), 1e-12);
      ++open;
    }
  }
  EXPECT_GT(std::min({shut, open, border}), 20);
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
        EXPECT_EQ(p[v], p[other]);
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

TEST(GrowthMotion, WhatWaitsGoesAlongWithTheOpenCracksBesideIt) {
  // No edge is changed by much more than the finished surface changes it.
  const Opening o("plate?n=30&jitter=0.3");
  const TriangleMesh& mesh = o.simulation.mesh();
  for (const double time : {0.2, 0.5, 0.8}) {
    const std::vector<Vec3> p = o.motion.positions(time);
    int turned = 0;
    for (const Triangle& t : mesh.triangles()) {
      turned += (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).z() <= 0;
    }
    EXPECT_EQ(turned, 0) << time;
  }
}

class GrowthOf : public testing::TestWithParam<const char*> {};

TEST_P(GrowthOf, TheSurfaceHardlyPassesThroughItselfOnTheWay) {
  const Opening o(GetParam());
  const auto& triangles = o.opened.mesh.triangles;
  for (double time = 0; time < 0.99; time += 0.1) {
    EXPECT_LE(self_intersections(o.motion.positions(time), triangles).size(),
              0.0005 * static_cast<double>(triangles.size()))
        << time;
  }
  // Only at the ends is it free of them by construction.
  EXPECT_TRUE(self_intersections(o.motion.positions(0), triangles).empty());
  EXPECT_TRUE(self_intersections(o.motion.positions(1), triangles).empty());
}

INSTANTIATE_TEST_SUITE_P(Post, GrowthOf,
                         testing::Values("sphere?n=12", "cup", "bowl", "torus",
                                         "plate?n=24&jitter=0.3"),
                         [](const auto& instance) {
                           const std::string name = instance.param;
                           return name.substr(0, name.find('?'));
                         });

}  // namespace
}  // namespace craze
