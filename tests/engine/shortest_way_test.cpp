// The short way over an asset, where no plane leads straight across.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "craze/base/random.h"
#include "craze/engine/asset/shortest_way.h"
#include "craze/shapes.h"
#include "engine/asset_cases.h"

namespace craze {
namespace {

constexpr double anything = 1e9;

/// Ways between random points, checked one by one.
template <class Check>
void for_random_ways(const SurfaceMesh& asset, int count, Check&& check) {
  const AssetTopology topology(asset.positions, asset.triangles);
  SiteTable sites(asset, topology, 0);
  ShortestWay search(asset, topology, sites);
  Random random(5);
  for (int k = 0; k < count; ++k) {
    std::int32_t ends[2];
    for (std::int32_t& site : ends) {
      const auto f = static_cast<std::int32_t>(random.below(asset.triangles.size()));
      site = random.below(3) == 0   ? sites.at_place(topology.from(3 * f))
             : random.below(2) == 0 ? sites.on_halfedge(3 * f, 0.3)
                                    : sites.at({f, test::random_weights(random)});
    }
    if (sites.common_face(ends[0], ends[1]) >= 0) continue;
    const SurfaceWay way = search.find(ends[0], ends[1], anything);
    ASSERT_GE(way.last_face, 0);
    ASSERT_TRUE(sites.touches(ends[1], way.last_face));
    ASSERT_TRUE(sites.touches(ends[0], way.crossings.front().face));
    for (std::size_t i = 0; i < way.crossings.size(); ++i) {
      const Crossing& c = way.crossings[i];
      ASSERT_EQ(c.halfedge / 3, c.face);
      ASSERT_GE(c.share, 0);
      ASSERT_LE(c.share, 1);
      const std::int32_t next =
          i + 1 < way.crossings.size() ? way.crossings[i + 1].face : way.last_face;
      ASSERT_NE(next, c.face);
      const HalfedgeRange sides = topology.sides(topology.edge(c.halfedge));
      ASSERT_TRUE(*sides.begin() / 3 == next || *(sides.begin() + 1) / 3 == next);
    }
    check((sites.position(ends[0]) - sites.position(ends[1])).norm(), way.length);
  }
}

TEST(TheShortestWay, OnAPlaneIsTheChord) {
  for (const std::string name : {"plate?n=8&jitter=0.4", "strip?n=4&length=3&width=0.5"}) {
    SCOPED_TRACE(name);
    for_random_ways(make_shape(name), 300, [](double chord, double length) {
      EXPECT_NEAR(length, chord, 1e-9 * (1 + chord));
    });
  }
}

TEST(TheShortestWay, OnAPlaneOfNeedlesIsTheChord) {
  for_random_ways(test::needles(make_shape("plate?n=6&jitter=0.3"), 1e-4), 300,
                  [](double chord, double length) {
                    EXPECT_GE(length, chord * (1 - 1e-9));
                    EXPECT_LE(length, chord + 1e-3);  // up to a few heights of the whole strip
                  });
}

TEST(TheShortestWay, OnASphereIsNearlyTheArcWhereThatIsNearItsChord) {
  int near = 0;
  for_random_ways(make_shape("sphere?n=24"), 1000, [&](double chord, double length) {
    EXPECT_GE(length, chord);
    if (chord > 0.5) return;
    ++near;
    EXPECT_LE(length, 1.03 * 2 * std::asin(chord / 2));
  });
  EXPECT_GT(near, 20);
}

TEST(TheShortestWay, LeadsOverAllOfABlockFullOfTunnels) {
  for_random_ways(test::sponge(), 300,
                  [](double chord, double length) { EXPECT_GE(length, chord * (1 - 1e-12)); });
}

TEST(TheShortestWay, IsNoneBetweenPartsNorWhereItWouldBeTooLong) {
  SurfaceMesh asset = make_shape("plate?n=4");
  const SurfaceMesh other = test::moved(asset, {1.5, 0, 0});
  const auto first = static_cast<std::int32_t>(asset.positions.size());
  const auto faces = static_cast<std::int32_t>(asset.triangles.size());
  asset.positions.insert(asset.positions.end(), other.positions.begin(), other.positions.end());
  for (const Triangle& t : other.triangles) {
    asset.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const AssetTopology topology(asset.positions, asset.triangles);
  SiteTable sites(asset, topology, 0);
  ShortestWay search(asset, topology, sites);
  const Vec3 middle(.4, .3, .3);
  const std::int32_t a = sites.at({0, middle}), b = sites.at({faces - 1, middle}),
                     c = sites.at({faces, middle});
  EXPECT_EQ(search.find(a, c, anything).last_face, -1);
  const double chord = (sites.position(a) - sites.position(b)).norm();
  EXPECT_EQ(search.find(a, b, 0.99 * chord).last_face, -1);
  EXPECT_GE(search.find(a, b, 1.01 * chord).last_face, 0);
}

}  // namespace
}  // namespace craze
