// [IO06] §4.2 and Fig. 5 on stars small enough to see.
#include "craze/model/cutting/crack_insertion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/mesh/validate.h"
#include "model/states.h"

namespace craze {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr CrackRules rules{25 * degree, 15 * degree};  // the paper's examples

/// `faces` equal triangles around vertex 0, spanning `span` radians from the x axis; a second ring
/// lies around them, so that the edges opposite to vertex 0 have two faces.
TriangleMesh fan(int faces, double span) {
  const bool closed = span > 359 * degree;
  const int spokes = closed ? faces : faces + 1;
  std::vector<Vec3> positions{Vec3::Zero()};
  std::vector<Triangle> triangles;
  for (const double radius : {1.0, 2.0}) {
    for (int i = 0; i < spokes; ++i) {
      const double angle = span * i / faces;
      positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
  }
  for (int i = 0; i < faces; ++i) {
    const int a = 1 + i, b = 1 + (i + 1) % spokes;
    triangles.push_back({0, a, b});
    triangles.push_back({a, a + spokes, b + spokes});
    triangles.push_back({a, b + spokes, b});
  }
  return {positions, triangles};
}

struct Opened {
  TriangleMesh mesh;
  CrackOutcome outcome;
};

/// Opens the crack that runs in the direction of `angle` (and back) through vertex 0.
Opened open(TriangleMesh mesh, double angle, const CrackRules& with = rules) {
  CrackedSheet sheet = test::sheet_of(std::move(mesh), Sym3{1, 2, 0, 0.5, 0, 0});
  CrackOutcome outcome;
  open_crack(sheet, 0, {-std::sin(angle), std::cos(angle), 0}, with, 0, outcome);
  EXPECT_TRUE(validate(sheet.mesh()).empty());
  return {sheet.mesh(), std::move(outcome)};
}

double direction_of(const Opened& o, const CrackSegment& s) {
  const Vec3 d = o.mesh.position(s.to_root) - o.mesh.position(s.from_root);
  return std::atan2(d.y(), d.x());
}

TEST(CrackInsertion, SplitsTheTrianglesThatThePlaneMeets) {
  // Spokes every 60°, crack at 30° and 210°: as far from the spokes as can be.
  const Opened o = open(fan(6, 360 * degree), 30 * degree);
  ASSERT_EQ(o.outcome.segments.size(), 2u);
  EXPECT_NEAR(direction_of(o, o.outcome.segments[0]), 30 * degree, 1e-12);
  EXPECT_NEAR(direction_of(o, o.outcome.segments[1]), -150 * degree, 1e-12);
  // Two opposite edges split, with both faces of each; the node in the middle falls in two.
  EXPECT_EQ(o.mesh.face_count(), 18 + 4);
  EXPECT_EQ(o.mesh.vertex_count(), 13 + 2 + 1);
  EXPECT_EQ(o.outcome.tips.size(), 2u);
  EXPECT_EQ(o.mesh.root(o.mesh.vertex_count() - 1), 0);
}

TEST(CrackInsertion, SnapsToAMeshEdgeCloserThanTheta1) {
  for (const double angle : {0.0, 5.0, 24.0, 36.0, 60.0, -24.0}) {
    const Opened o = open(fan(6, 360 * degree), angle * degree);
    ASSERT_EQ(o.outcome.segments.size(), 2u) << angle;
    EXPECT_EQ(o.mesh.face_count(), 18) << angle;  // nothing was split
    const double turned =
        direction_of(o, o.outcome.segments[0]) - 60 * degree * std::round(angle / 60);
    EXPECT_NEAR(std::sin(turned), 0, 1e-12) << angle;  // either of the two segments
  }
}

TEST(CrackInsertion, DoesNotSnapBeyondTheta1) {
  for (const double angle : {26.0, 30.0, 34.0}) {
    const Opened o = open(fan(6, 360 * degree), angle * degree);
    EXPECT_EQ(o.mesh.face_count(), 22) << angle;
  }
  // θ₁ is a parameter: at 10° the crack at 12° keeps its own way.
  const Opened o = open(fan(6, 360 * degree), 12 * degree, {10 * degree, 5 * degree});
  EXPECT_NEAR(direction_of(o, o.outcome.segments[0]), 12 * degree, 1e-12);
}

TEST(CrackInsertion, DropsASegmentCloserThanTheta2ToACrackEdgeAlreadyThere) {
  // A node on an open edge along the x axis. The plane meets the star once.
  for (const double angle : {2.0, 8.0, 14.0, 166.0, 178.0}) {
    EXPECT_TRUE(open(fan(3, 180 * degree), angle * degree).outcome.empty()) << angle;
  }
  for (const double angle : {16.0, 30.0, 90.0, 150.0, 164.0}) {
    EXPECT_EQ(open(fan(3, 180 * degree), angle * degree).outcome.segments.size(), 1u) << angle;
  }
}

TEST(CrackInsertion, DoesNotSnapToAnEdgeThatIsOpenAlready) {
  // Between θ₂ and θ₁ of the open edge the segment is made where the plane runs.
  const Opened o = open(fan(3, 180 * degree), 20 * degree);
  ASSERT_EQ(o.outcome.segments.size(), 1u);
  EXPECT_NEAR(direction_of(o, o.outcome.segments[0]), 20 * degree, 1e-12);
}

TEST(CrackInsertion, WithoutAnAdmissibleSegmentNothingIsTouched) {
  const TriangleMesh before = fan(3, 180 * degree);
  const Opened o = open(before, 3 * degree);
  EXPECT_TRUE(o.outcome.empty());
  EXPECT_EQ(o.mesh.positions(), before.positions());
  EXPECT_EQ(o.mesh.triangles(), before.triangles());
  EXPECT_TRUE(o.outcome.changed_nodes.empty());
}

TEST(CrackInsertion, ANodeOnTheBorderIsSeparatedByOneSegment) {
  const Opened o = open(fan(3, 180 * degree), 90 * degree);
  ASSERT_EQ(o.outcome.segments.size(), 1u);
  const std::int32_t copy = o.mesh.vertex_count() - 1;
  EXPECT_EQ(o.mesh.root(copy), 0);
  EXPECT_EQ(o.mesh.position(copy), o.mesh.position(0));
  ASSERT_EQ(o.outcome.tips.size(), 1u);
  EXPECT_TRUE(o.mesh.is_open_vertex(o.outcome.tips[0]));
}

TEST(CrackInsertion, TwoSegmentsOfABentStarAreThoseThatHalveItBest) {
  // A star folded like a pleated filter: its plane cuts it in more than two places.
  std::vector<Vec3> positions{Vec3::Zero()};
  std::vector<Triangle> triangles;
  for (int i = 0; i < 8; ++i) {
    const double angle = 45 * degree * i;
    positions.emplace_back(std::cos(angle), std::sin(angle), i % 2 == 0 ? 0.8 : -0.8);
  }
  for (int i = 0; i < 8; ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % 8});
  CrackedSheet sheet = test::sheet_of(TriangleMesh(positions, triangles), Sym3{});
  CrackOutcome outcome;
  open_crack(sheet, 0, {0, 0, 1}, {0, 0}, 0, outcome);
  ASSERT_EQ(outcome.segments.size(), 2u);
  const TriangleMesh& mesh = sheet.mesh();
  const Vec3 a = mesh.position(outcome.segments[0].to_root);
  const Vec3 b = mesh.position(outcome.segments[1].to_root);
  EXPECT_LT(a.normalized().dot(b.normalized()), -0.99);
  EXPECT_TRUE(validate(mesh).empty());
}

TEST(CrackInsertion, ANodeWhoseStarThePlaneMissesIsLeftWhole) {
  // The tip of a cone, cut across its axis.
  std::vector<Vec3> positions{Vec3::Zero()};
  std::vector<Triangle> triangles;
  for (int i = 0; i < 6; ++i) {
    positions.emplace_back(std::cos(60 * degree * i), std::sin(60 * degree * i), -1);
    triangles.push_back({0, 1 + i, 1 + (i + 1) % 6});
  }
  CrackedSheet sheet = test::sheet_of(TriangleMesh(positions, triangles), Sym3{});
  CrackOutcome outcome;
  open_crack(sheet, 0, {0, 0, 1}, rules, 0, outcome);
  EXPECT_TRUE(outcome.empty());
}

TEST(CrackInsertion, ANewNodeTakesItsDisplacementFromTheEndsOfTheSplitEdge) {
  CrackedSheet sheet = test::sheet_of(fan(6, 360 * degree), Sym3{});
  const TriangleMesh& mesh = sheet.mesh();
  StressField& field = sheet.field();
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& p = mesh.position(v);  // a linear field: interpolation reproduces it
    field.displacements()[v].v = Vec4d::Lanes{2 * p.x() - p.y(), p.x() + 1, 3 * p.y(), 0};
  }
  CrackOutcome outcome;
  open_crack(sheet, 0, {-std::sin(0.5), std::cos(0.5), 0}, rules, 0, outcome);
  ASSERT_EQ(outcome.segments.size(), 2u);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& p = mesh.position(v);
    EXPECT_LT((field.displacement(v) - Vec3(2 * p.x() - p.y(), p.x() + 1, 3 * p.y())).norm(),
              1e-12);
  }
}

}  // namespace
}  // namespace craze
