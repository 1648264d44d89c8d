#include "craze/mesh/remesh/remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "craze/error.h"
#include "craze/mesh/closest_point.h"
#include "craze/mesh/mesh_summary.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/mesh/validate.h"
#include "craze/repair.h"
#include "craze/shapes.h"

namespace craze {
namespace {

MeshSummary sound_summary(const SurfaceMesh& s) {
  const TriangleMesh mesh(s.positions, s.triangles);
  const auto problems = validate(mesh);
  EXPECT_TRUE(problems.empty()) << problems.front();
  const MeshSummary summary = summarize(mesh);
  EXPECT_EQ(summary.vertices, static_cast<std::int32_t>(s.positions.size()));
  return summary;
}

SurfaceMesh remeshed(const SurfaceMesh& s, double edge, bool coarsen = false) {
  RemeshOptions options;
  options.target_edge = edge;
  options.coarsen = coarsen;
  return remesh(s, options, {});
}

double smallest_angle(const SurfaceMesh& s) {
  double smallest = 180;
  for (const Triangle& t : s.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = s.positions[t[(i + 1) % 3]] - s.positions[t[i]];
      const Vec3 b = s.positions[t[(i + 2) % 3]] - s.positions[t[i]];
      smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  return smallest * 180 / std::numbers::pi;
}

// |Σ e^{ikθ}| / #E over the inner edges of a mesh in the xy plane: 1 if all run along k-fold axes.
double grain(const SurfaceMesh& s, int fold) {
  const TriangleMesh mesh(s.positions, s.triangles);
  Vec2 sum = Vec2::Zero();
  double edges = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) > h || mesh.is_open(h)) continue;
    const Vec3 e = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
    const double angle = fold * std::atan2(e.y(), e.x());
    sum += Vec2(std::cos(angle), std::sin(angle));
    edges += 1;
  }
  return sum.norm() / edges;
}

// The largest distance from a's corners, edge middles and face middles to b.
double distance(const SurfaceMesh& a, const SurfaceMesh& b) {
  const ClosestPoint tree(b.positions, b.triangles);
  double largest = 0;
  for (const Triangle& t : a.triangles) {
    const Vec3 &p = a.positions[t[0]], &q = a.positions[t[1]], &r = a.positions[t[2]];
    for (const Vec3& x : {p, Vec3((p + q) / 2), Vec3((q + r) / 2), Vec3((p + q + r) / 3)}) {
      largest = std::max(largest, tree.find(x).distance);
    }
  }
  return largest;
}

double uv_area(const SurfaceMesh& s, std::size_t f) {
  const Vec2 a = s.corner_uvs[3 * f + 1] - s.corner_uvs[3 * f];
  const Vec2 b = s.corner_uvs[3 * f + 2] - s.corner_uvs[3 * f];
  return (a.x() * b.y() - a.y() * b.x()) / 2;
}

TEST(Remesh, ACoarseCubeGetsEvenTrianglesOfTheAskedSizeAndKeepsItsEdges) {
  const SurfaceMesh s = remeshed(make_shape("cube?n=1"), 0.05);
  const MeshSummary m = sound_summary(s);
  EXPECT_TRUE(m.closed());
  EXPECT_EQ(m.genus, 0);
  EXPECT_NEAR(m.area, 6, 1e-9);
  EXPECT_NEAR(m.volume, 1, 1e-9);
  EXPECT_NEAR(m.edge_mean, 0.05, 0.05 * 0.06);
  EXPECT_LT(m.edge_max, 0.05 * 2);
  EXPECT_GT(smallest_angle(s), 18);
}

TEST(Remesh, UvChartsAndMaterialsKeepTheirAreaAndNothingFlips) {
  SurfaceMesh cube = make_shape("cube?n=2");
  for (std::size_t f = 0; f < cube.triangles.size(); ++f) {
    cube.face_materials.push_back(static_cast<std::int32_t>(f / 8));
  }
  const SurfaceMesh s = remeshed(cube, 0.07);
  std::map<std::int32_t, Vec2> areas;  // of each material, on the surface and in UV space
  const TriangleMesh mesh(s.positions, s.triangles);
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    EXPECT_GT(uv_area(s, f), 0);
    auto [found, added] = areas.try_emplace(s.face_materials[f], 0, 0);
    found->second += Vec2(mesh.area(static_cast<std::int32_t>(f)), uv_area(s, f));
  }
  ASSERT_EQ(areas.size(), 6u);
  for (const auto& [material, area] : areas) {
    EXPECT_NEAR(area[0], 1, 1e-9);
    EXPECT_NEAR(area[1], 0.96 * 0.96 / 6, 1e-9);
  }
}

TEST(Remesh, TheSeamOfALatheStaysASeam) {
  const SurfaceMesh s = remeshed(make_shape("cylinder?n=40&open=1"), 0.1);
  const double widest = 2 * 0.1 / (2 * std::numbers::pi);  // two edges, as a part of a turn
  double area = 0;
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    EXPECT_GT(uv_area(s, f), 0);
    area += uv_area(s, f);
    const double a = s.corner_uvs[3 * f].x(), b = s.corner_uvs[3 * f + 1].x(),
                 c = s.corner_uvs[3 * f + 2].x();
    EXPECT_LT(std::max({a, b, c}) - std::min({a, b, c}), widest) << "face " << f;
  }
  const SurfaceMesh input = make_shape("cylinder?n=40&open=1");
  double before = 0;
  for (std::size_t f = 0; f < input.triangles.size(); ++f) before += uv_area(input, f);
  EXPECT_NEAR(area / before, 1, 1e-3);
}

TEST(Remesh, ARegularGridLosesItsGrain) {
  const SurfaceMesh plate = make_shape("plate?n=50");
  EXPECT_GT(grain(plate, 4), 0.2);
  for (const bool coarsen : {false, true}) {
    const SurfaceMesh s = remeshed(plate, 0.02, coarsen);
    for (const int fold : {2, 4, 6, 8}) EXPECT_LT(grain(s, fold), 0.06) << fold;
    EXPECT_GT(smallest_angle(s), 20);
    EXPECT_NEAR(sound_summary(s).area, 1, 1e-12);
  }
}

TEST(Remesh, TheSurfaceStaysWithinTheDistanceBothWays) {
  const SurfaceMesh sphere = make_shape("sphere?n=20");
  for (const double bound : {0.002, 0.01}) {
    RemeshOptions options;
    options.target_edge = 0.15;
    options.max_distance = bound;
    options.coarsen = true;
    const SurfaceMesh s = remesh(sphere, options, {});
    EXPECT_LE(distance(s, sphere), bound * (1 + 1e-9));
    EXPECT_LE(distance(sphere, s), 2 * bound);
    EXPECT_TRUE(sound_summary(s).closed());
  }
}

TEST(Remesh, CoarseningIsDoneOnlyIfAsked) {
  const SurfaceMesh sphere = make_shape("sphere?n=20");
  const double before = summarize(TriangleMesh(sphere.positions, sphere.triangles)).edge_mean;
  EXPECT_LT(sound_summary(remeshed(sphere, 0.2)).edge_mean, 1.05 * before);
  EXPECT_NEAR(sound_summary(remeshed(sphere, 0.2, true)).edge_mean, 0.2, 0.02);
}

TEST(Remesh, ATorusStaysATorus) {
  const MeshSummary m = sound_summary(remeshed(make_shape("torus?n=30"), 0.12));
  EXPECT_EQ(m.genus, 1);
  EXPECT_TRUE(m.closed());
  EXPECT_GT(m.volume, 0);
}

TEST(Remesh, BordersKeepTheirCourse) {
  const SurfaceMesh strip = make_shape("strip?n=3&length=4");
  const SurfaceMesh s = remeshed(strip, 0.08);
  const TriangleMesh mesh(s.positions, s.triangles);
  double border = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.is_open(h)) border += (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
  }
  EXPECT_NEAR(border, 10, 1e-9);
  EXPECT_NEAR(mesh.total_area(), 4, 1e-9);
}

TEST(Remesh, SliversAreReplacedByEvenTriangles) {
  SurfaceMesh s = make_shape("plate?n=20");
  for (Vec3& p : s.positions) p.x() *= 12;
  EXPECT_LT(smallest_angle(s), 5);
  EXPECT_GT(smallest_angle(remeshed(s, 0.3)), 15);
}

TEST(Remesh, AttributesAreThoseOfTheSurfaceBelow) {
  SurfaceMesh plate = make_shape("plate?n=9&jitter=0.4");
  plate.vertex_attributes = {{"place", 2, {}}};
  for (const Vec3& p : plate.positions) {
    plate.vertex_attributes[0].values.insert(plate.vertex_attributes[0].values.end(),
                                             {p.x(), 3 * p.y()});
    plate.vertex_colors.push_back({static_cast<float>(p.x() + 0.5), 0, 0, 1});
  }
  plate.face_attributes = {{"id", 1, {}}};
  for (std::size_t f = 0; f < plate.triangles.size(); ++f) {
    plate.face_attributes[0].values.push_back(static_cast<double>(f));
    for (int i = 0; i < 3; ++i) plate.corner_normals.emplace_back(0, 0, 1);
  }
  const SurfaceMesh s = remeshed(plate, 0.03);
  ASSERT_GT(s.triangles.size(), plate.triangles.size());
  for (std::size_t v = 0; v < s.positions.size(); ++v) {
    EXPECT_NEAR(s.vertex_attributes[0].values[2 * v], s.positions[v].x(), 1e-9);
    EXPECT_NEAR(s.vertex_attributes[0].values[2 * v + 1], 3 * s.positions[v].y(), 1e-9);
    EXPECT_NEAR(s.vertex_colors[v][0], s.positions[v].x() + 0.5, 1e-5);
  }
  for (std::size_t c = 0; c < s.corner_uvs.size(); ++c) {
    const Vec3& p = s.positions[s.triangles[c / 3][c % 3]];
    EXPECT_NEAR(s.corner_uvs[c].x(), p.x() + 0.5, 1e-9);
    EXPECT_NEAR(s.corner_uvs[c].y(), p.y() + 0.5, 1e-9);
    EXPECT_NEAR(s.corner_normals[c].z(), 1, 1e-12);
  }
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    const Triangle& t = s.triangles[f];
    const Vec3 middle = (s.positions[t[0]] + s.positions[t[1]] + s.positions[t[2]]) / 3;
    const Triangle& under = plate.triangles[s.source_faces[f]];
    const Vec3 w = nearest_weights(middle, plate.positions[under[0]], plate.positions[under[1]],
                                   plate.positions[under[2]]);
    const Vec3 at = w[0] * plate.positions[under[0]] + w[1] * plate.positions[under[1]] +
                    w[2] * plate.positions[under[2]];
    EXPECT_NEAR((at - middle).norm(), 0, 1e-9);
    EXPECT_EQ(s.face_attributes[0].values[f], s.source_faces[f]);
  }
}

TEST(Remesh, IsTheSameOnAnyNumberOfThreadsAndFollowsTheSeed) {
  const SurfaceMesh cup = make_shape("cup?n=60");
  RemeshOptions options;
  options.target_edge = 0.03;
  Context one, four;
  one.threads = 1;
  four.threads = 4;
  const SurfaceMesh a = remesh(cup, options, one), b = remesh(cup, options, four);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.corner_uvs, b.corner_uvs);
  EXPECT_EQ(a.source_faces, b.source_faces);
  options.seed = 2;
  EXPECT_NE(remesh(cup, options, one).positions, a.positions);
}

TEST(Remesh, ThinWallsStayApart) {
  const SurfaceMesh cup = make_shape("cup?n=60&wall=0.02");
  const SurfaceMesh s = remeshed(cup, 0.04);  // edges twice as long as the wall is thick
  const MeshSummary before = sound_summary(cup), after = sound_summary(s);
  EXPECT_TRUE(after.closed());
  EXPECT_EQ(after.genus, 0);
  EXPECT_NEAR(after.volume / before.volume, 1, 0.05);
  EXPECT_NEAR(after.area / before.area, 1, 0.01);
}

TEST(Remesh, IsCancelledWheneverTheContextSaysSo) {
  RemeshOptions options;
  options.target_edge = 0.05;
  const SurfaceMesh cube = make_shape("cube?n=3");
  int polls = 0;
  Context context;
  context.cancelled = [&] { return ++polls < 0; };
  remesh(cube, options, context);
  ASSERT_GT(polls, 40);
  for (int last = 1, all = polls; last <= all; last += 7) {
    polls = 0;
    context.cancelled = [&] { return ++polls >= last; };
    EXPECT_THROW(remesh(cube, options, context), Cancelled) << last;
    EXPECT_EQ(polls, last) << "goes on after it was cancelled";
  }
}

TEST(Remesh, SaysHowFarItIsAndNeverGoesBack) {
  RemeshOptions options;
  options.target_edge = 0.02;
  Context context;
  std::vector<double> fractions;
  context.progress = [&](const Progress& p) {
    EXPECT_EQ(p.phase, "remesh");
    fractions.push_back(p.fraction);
  };
  remesh(make_shape("cube?n=3"), options, context);
  ASSERT_GT(fractions.size(), 30u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
}

TEST(Remesh, RefusesCoordinatesWithTooFewDigitsForItsEdges) {
  SurfaceMesh plate = make_shape("plate?n=10");
  const auto moved = [&](double far) {
    SurfaceMesh mesh = plate;
    for (Vec3& p : mesh.positions) p.x() += far;
    return mesh;
  };
  EXPECT_THROW(remeshed(moved(1e15), 0.03), Error);
  EXPECT_THROW(remeshed(moved(1e13), 0.016), Error);
  const auto count = [&](double far) {
    return static_cast<double>(remeshed(moved(far), 0.032).triangles.size());
  };
  EXPECT_NEAR(count(1e13) / count(0), 1, 0.05);
}

TEST(Remesh, RefusesTargetsThatAreNoLengthOrTooFine) {
  const SurfaceMesh plate = make_shape("plate?n=2");
  EXPECT_THROW(remeshed(plate, 0), Error);
  EXPECT_THROW(remeshed(plate, -1), Error);
  EXPECT_THROW(remeshed(plate, std::nan("")), Error);
  EXPECT_THROW(remeshed(plate, 1e-6), Error);
  EXPECT_TRUE(remeshed(SurfaceMesh{}, 1).triangles.empty());
}

}  // namespace
}  // namespace craze
