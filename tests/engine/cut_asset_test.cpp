// Curves of a kind of their own, one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "craze/error.h"
#include "craze/shapes.h"
#include "engine/asset_cases.h"
#include "engine/cut_checks.h"

namespace craze {
namespace {

/// The corner of an asset's face that lies at p.
SurfacePoint corner_at(const SurfaceMesh& asset, const Vec3& p) {
  for (std::size_t f = 0; f < asset.triangles.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      if ((asset.positions[asset.triangles[f][i]] - p).norm() < 1e-12) {
        return {static_cast<std::int32_t>(f), Vec3::Unit(i)};
      }
    }
  }
  return {};
}

TEST(ACut, AlongEdgesSplitsNoFace) {
  const SurfaceMesh asset = make_shape("plate?n=4");
  CrackCurves curves;
  for (const double x : {-0.25, 0.0, 0.25}) curves.points.push_back(corner_at(asset, {x, 0, 0}));
  curves.edges = {{0, 1}, {1, 2}};
  const CutAsset cut = test::cut(asset, curves, {});
  test::check_cut(asset, cut);
  EXPECT_EQ(cut.report.split_faces, 0);
  EXPECT_EQ(cut.triangles.size(), asset.triangles.size());
  EXPECT_EQ(cut.positions.size(), asset.positions.size() + 1);
  EXPECT_EQ(cut.edges.size(), 2u);
}

TEST(ACut, LeavesFacesWithoutCurvesBitForBit) {
  const SurfaceMesh asset = test::dressed(make_shape("sphere?n=8"));
  const CrackCurves curves{{{100, Vec3(.2, .3, .5)}, {103, Vec3(.5, .3, .2)}}, {{0, 1}}};
  const CutAsset cut = test::cut(asset, curves, {});
  test::check_cut(asset, cut);
  EXPECT_GT(cut.report.split_faces, 0);
  EXPECT_LT(cut.report.split_faces, 20);
  for (std::size_t f = 0; f < asset.triangles.size(); ++f) {
    if (std::binary_search(cut.parts.begin(), cut.parts.end(), static_cast<std::int32_t>(f))) {
      continue;
    }
    EXPECT_EQ(cut.triangles[f], asset.triangles[f]);
  }
}

TEST(ACut, OfOneSegmentInsideAFaceIsASlitWithTwoTips) {
  const SurfaceMesh asset = make_shape("plate?n=1");
  const CrackCurves curves{{{0, Vec3(.6, .2, .2)}, {0, Vec3(.3, .4, .3)}}, {{0, 1}}};
  const CutAsset cut = test::cut(asset, curves, {});
  test::check_cut(asset, cut);
  EXPECT_EQ(cut.edges.size(), 2u);  // a vertex between the tips, or it could not open
  EXPECT_EQ(cut.positions.size(), asset.positions.size() + 4);
}

TEST(ACut, OfACurveThatTurnsBackJustBeyondAnEdgeHasNoSpurThere) {
  SurfaceMesh asset;
  asset.positions = {Vec3(0, -1, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(1, 0, 0)};
  asset.triangles = {{0, 1, 2}, {1, 0, 3}};
  const auto at = [](double x, double y) {  // the edge is x = 0
    const double share = (1 - std::abs(x) + y) / 2;
    return x < 0 ? SurfacePoint{0, Vec3(1 + x - share, share, -x)}
                 : SurfacePoint{1, Vec3(share, 1 - x - share, x)};
  };
  const CrackCurves curves{{at(-0.2, -0.03), at(0.02, 0), at(-0.2, 0.03), at(-0.4, 0.03)},
                           {{0, 1}, {1, 2}, {2, 3}}};
  const CutAsset cut = test::cut(asset, curves, {0.015, nullptr, {}});
  test::check_cut(asset, cut);
  const auto place = weld(cut.positions, 0);
  std::map<std::int32_t, int> degrees;
  for (const CutEdge& e : cut.edges) {
    const Triangle& t = cut.triangles[e.side[0] / 3];
    for (const int k : {0, 1}) ++degrees[place[t[(e.side[0] + k) % 3]]];
  }
  for (const auto& [v, degree] : degrees) EXPECT_LE(degree, 2);
  int tips = 0;
  for (const std::size_t p : {0, 1, 2, 3}) tips += degrees.at(place[cut.point_vertex[p]]) == 1;
  EXPECT_EQ(tips, 2);
  EXPECT_EQ(cut.positions[cut.point_vertex[1]].x(), 0);
}

TEST(ACut, LeftSidesLieLeftOfTheirCurve) {
  const SurfaceMesh asset = make_shape("plate?n=6&jitter=0.3");
  Random random(4);
  const CrackCurves curves = test::random_curves(asset, random, {});
  const CutAsset cut = test::cut(asset, curves, {});
  ASSERT_FALSE(cut.edges.empty());
  for (const CutEdge& e : cut.edges) {
    const auto& [p, q] = curves.edges[e.curve_edge];
    const Vec3 a = cut.positions[cut.point_vertex[p]], b = cut.positions[cut.point_vertex[q]];
    for (const int side : {0, 1}) {
      if (e.side[side] < 0) continue;
      const Triangle& t = cut.triangles[e.side[side] / 3];
      const Vec3 middle = (cut.positions[t[0]] + cut.positions[t[1]] + cut.positions[t[2]]) / 3;
      const double left = (b - a).cross(middle - a).z();
      EXPECT_GT(side == 0 ? left : -left, 0);
    }
  }
}

TEST(ACut, MakesAVertexOfAPointWithoutEdges) {
  const SurfaceMesh asset = make_shape("cube?n=1");
  const CutAsset cut = test::cut(asset, {{{3, Vec3(.2, .3, .5)}}, {}}, {});
  test::check_cut(asset, cut);
  EXPECT_EQ(cut.triangles.size(), asset.triangles.size() + 2);
  EXPECT_EQ(cut.point_vertex[0], static_cast<std::int32_t>(asset.positions.size()));
}

TEST(ACut, GivesUpAndCountsWhatWouldCrossAGap) {
  SurfaceMesh asset = make_shape("plate?n=1");
  const SurfaceMesh other = test::moved(asset, {1.5, 0, 0});
  const auto first = static_cast<std::int32_t>(asset.positions.size());
  asset.positions.insert(asset.positions.end(), other.positions.begin(), other.positions.end());
  for (const Triangle& t : other.triangles) {
    asset.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const CrackCurves curves{{{0, Vec3(.4, .3, .3)}, {3, Vec3(.4, .3, .3)}}, {{0, 1}}};
  const CutAsset cut = test::cut(asset, curves, {});
  test::check_cut(asset, cut);
  EXPECT_GT(cut.report.traced.lost, 0);
  EXPECT_GE(cut.report.traced.lost_length, 0.5);
}

TEST(ACut, IsTheSameEveryTime) {
  const SurfaceMesh asset = make_shape("bumps?n=5");
  Random random(9);
  const CrackCurves curves = test::random_curves(asset, random, {});
  const CutAsset a = test::cut(asset, curves, {0.01}), b = test::cut(asset, curves, {0.01});
  EXPECT_EQ(a.triangles, b.triangles);
  ASSERT_EQ(a.positions.size(), b.positions.size());
  EXPECT_TRUE(test::same_bits(a.positions.data(), b.positions.data(), a.positions.size()));
}

TEST(ACut, RefusesPointsAndEdgesThatNameNothing) {
  const SurfaceMesh asset = make_shape("plate?n=1");
  EXPECT_THROW(test::cut(asset, {{{7, Vec3(1, 0, 0)}}, {}}, {}), Error);
  EXPECT_THROW(test::cut(asset, {{{0, Vec3(1, 0, 0)}}, {{0, 1}}}, {}), Error);
}

TEST(ACut, GrowsTheMeshLinearlyInTheLengthOfItsCurves) {
  const SurfaceMesh asset = make_shape("cube?n=1");
  std::vector<double> per_edge;
  for (const int chains : {50, 200, 800}) {
    CrackCurves curves;  // strokes of one length that hardly ever cross
    Random random(2);
    for (int k = 0; k < chains; ++k) {
      const auto f = static_cast<std::int32_t>(random.below(asset.triangles.size()));
      const double x = random.uniform(0.05, 0.45), y = random.uniform(0.05, 0.45);
      for (const double s : {0.0, 0.005, 0.01}) {
        curves.points.push_back({f, Vec3(1 - x - s - y, x + s, y)});
      }
      const auto last = static_cast<std::int32_t>(curves.points.size()) - 1;
      curves.edges.push_back({last - 2, last - 1});
      curves.edges.push_back({last - 1, last});
    }
    const CutAsset cut = test::cut(asset, curves, {});
    per_edge.push_back(double(cut.triangles.size() - asset.triangles.size()) /
                       double(cut.edges.size()));
  }
  EXPECT_NEAR(per_edge[2], per_edge[0], 0.05 * per_edge[0]);
}

}  // namespace
}  // namespace craze
