#include "craze/products/distance/crack_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "craze/base/random.h"
#include "craze/base/segment_distance.h"
#include "craze/mesh/components.h"
#include "products/distance/surfaces.h"

namespace craze {
namespace {

using test::cut_at_random;
using test::grid;
using test::plate;

constexpr double infinity = std::numeric_limits<double>::infinity();

double straight_distance(const TriangleMesh& mesh, const Vec3& p) {
  double nearest = infinity;
  for (const std::int32_t h : crack_sides(mesh)) {
    nearest = std::min(
        nearest, point_segment_distance(p, mesh.position(mesh.from(h)), mesh.position(mesh.to(h))));
  }
  return nearest;
}

TEST(CrackDistance, OnAFlatPlateItIsTheStraightDistanceAtEveryPointOfEveryFace) {
  TriangleMesh mesh = plate(14, 0.35);
  cut_at_random(mesh, 12, 0, 5);
  const NearbyCracks cracks = nearby_cracks(mesh, crack_sides(mesh), infinity, {});
  Random random(9);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle& t = mesh.triangle(f);
    const double u = random.uniform(), v = random.uniform() * (1 - u);
    const Vec3 p =
        (1 - u - v) * mesh.position(t[0]) + u * mesh.position(t[1]) + v * mesh.position(t[2]);
    EXPECT_NEAR(crack_distance(cracks, f, p), straight_distance(mesh, p), 1e-12);
  }
  const std::vector<double> at_vertices = crack_distances(mesh, infinity, {});
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_NEAR(at_vertices[v], straight_distance(mesh, mesh.position(v)), 1e-12);
  }
}

TEST(CrackDistance, IsExactInsideTheTwoTrianglesOfACoarseMesh) {
  TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  mesh.cut(2, 0);
  const NearbyCracks cracks = nearby_cracks(mesh, crack_sides(mesh), infinity, {});
  EXPECT_NEAR(crack_distance(cracks, 0, {0.6, 0.4, 0}), 0.2 / std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(crack_distance(cracks, 1, {0, 1, 0}), 1 / std::sqrt(2.0), 1e-15);
}

TEST(CrackDistance, OnACylinderItIsMeasuredRoundTheCylinder) {
  const int n = 24;
  TriangleMesh mesh = grid(n, 10, true, false, [](double s, double t) {
    const double angle = 2 * std::numbers::pi * s;
    return Vec3(std::cos(angle), std::sin(angle), t);
  });
  // Open the generator at angle 0 from end to end.
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const auto on_line = [&](std::int32_t v) {
      return (mesh.position(v).head<2>() - Vec2(1, 0)).norm() < 1e-9;
    };
    if (!mesh.is_open(h) && on_line(mesh.from(h)) && on_line(mesh.to(h))) mesh.cut(h, 0);
  }
  const std::vector<double> distance = crack_distances(mesh, infinity, {});
  const double side = 2 * std::sin(std::numbers::pi / n);  // of the regular polygon
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const double angle = std::abs(std::atan2(mesh.position(v).y(), mesh.position(v).x()));
    const double steps = std::round(angle * n / (2 * std::numbers::pi));
    EXPECT_NEAR(distance[v], steps * side, 1e-9);
  }
}

/// Lengths of the shortest ways from cracks to vertices over straight lines between points on
/// edges, five on each: a little longer than the shortest of all ways.
std::vector<double> lengths_of_ways(const TriangleMesh& mesh) {
  constexpr int each = 5;
  const auto points_of = [&](std::int32_t f) {
    std::vector<std::int32_t> points;
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      const std::int32_t o = mesh.is_open(h) ? h : mesh.opposite(h);
      points.push_back(mesh.from(h));
      for (int i = 0; i < each; ++i)
        points.push_back(mesh.vertex_count() + each * std::min(h, o) + (h <= o ? i : each - 1 - i));
    }
    return points;
  };
  std::vector<Vec3> positions(mesh.vertex_count() + 3 * each * mesh.face_count());
  std::vector<std::vector<std::int32_t>> faces_at(positions.size());
  std::vector<double> length(positions.size(), infinity);
  std::set<std::pair<double, std::int32_t>> front;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const std::vector<std::int32_t> points = points_of(f);
    for (int k = 0; k < 3 * (each + 1); ++k) {
      const std::int32_t h = 3 * f + k / (each + 1), p = points[k];
      const Vec3 &from = mesh.position(mesh.from(h)), &to = mesh.position(mesh.to(h));
      positions[p] = from + (k % (each + 1)) / (each + 1.0) * (to - from);
      faces_at[p].push_back(f);
      const bool on_crack = mesh.crack_of(h) >= 0 ||
                            (k % (each + 1) == 0 && mesh.crack_of(TriangleMesh::prev(h)) >= 0);
      if (!on_crack) continue;
      length[p] = 0;
      front.insert({0, p});
    }
  }
  while (!front.empty()) {
    const auto [so_far, p] = *front.begin();
    front.erase(front.begin());
    for (const std::int32_t f : faces_at[p]) {
      for (const std::int32_t q : points_of(f)) {
        const double there = so_far + (positions[q] - positions[p]).norm();
        if (there >= length[q]) continue;
        front.erase({length[q], q});
        length[q] = there;
        front.insert({there, q});
      }
    }
  }
  length.resize(mesh.vertex_count());
  return length;
}

TEST(CrackDistance, OnABumpySurfaceItIsNearTheLengthOfTheShortestWay) {
  TriangleMesh mesh = grid(24, 24, false, false, [](double s, double t) {
    return Vec3(s, t, 0.05 * std::sin(15 * s) * std::sin(12 * t + 1));
  });
  cut_at_random(mesh, 20, 0, 3);
  const std::vector<double> distance = crack_distances(mesh, infinity, {});
  const std::vector<double> length = lengths_of_ways(mesh);
  double sum = 0, off = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    sum += length[v];
    off += std::abs(distance[v] - length[v]);
  }
  EXPECT_LT(off, 0.05 * sum);
}

TEST(CrackDistance, ACrackDoesNotShowThroughAThinWall) {
  // A strip folded over a rim at x = 1: the back lies 0.01 behind the front.
  const double thickness = 0.01;
  TriangleMesh mesh = grid(60, 12, false, false, [&](double s, double t) {
    const double x = s * (2 + thickness);
    if (x <= 1) return Vec3(x, t, 0);
    if (x <= 1 + thickness) return Vec3(1, t, 1 - x);
    return Vec3(2 + thickness - x, t, -thickness);
  });
  std::int32_t cuts = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count() && cuts < 3; ++h) {
    const Vec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h));
    const bool along = std::abs(a.x() - b.x()) < 1e-9 && a.z() == 0 && b.z() == 0;
    if (along && std::abs(a.x() - 0.5) < 0.02 && !mesh.is_open(h)) mesh.cut(h, cuts++);
  }
  ASSERT_EQ(cuts, 3);
  const NearbyCracks near = nearby_cracks(mesh, crack_sides(mesh), 0.2, {});
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    bool behind = true;
    for (const std::int32_t v : mesh.triangle(f)) behind &= mesh.position(v).z() < 0;
    EXPECT_TRUE(!behind || near.of(f).empty());
  }
  const std::vector<double> distance = crack_distances(mesh, infinity, {});
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.position(v).z() > -thickness / 2) continue;
    EXPECT_GT(distance[v], 0.45 + 1 - mesh.position(v).x());
  }
}

TEST(CrackDistance, FacesBeyondTheReachListNothing) {
  TriangleMesh mesh = plate(20, 0.2);
  cut_at_random(mesh, 1, 0, 1);
  const double reach = 0.1;
  const NearbyCracks near = nearby_cracks(mesh, crack_sides(mesh), reach, {});
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    double farthest = 0, nearest = infinity;
    for (const std::int32_t v : mesh.triangle(f)) {
      const double d = straight_distance(mesh, mesh.position(v));
      farthest = std::max(farthest, d);
      nearest = std::min(nearest, d);
    }
    EXPECT_TRUE(nearest <= reach + 0.1 || near.of(f).empty());
    EXPECT_TRUE(farthest >= reach || !near.of(f).empty());
  }
}

/// A plate cut along lines into 36 square parts.
TriangleMesh tiles() {
  constexpr int n = 30, every = 5;
  TriangleMesh mesh = plate(n, 0);
  const auto on_a_line = [&](std::int32_t h, int axis) {
    const double a = n * mesh.position(mesh.from(h))[axis], b = n * mesh.position(mesh.to(h))[axis];
    const double line = every * std::round(a / every);
    return std::abs(a - line) < 1e-9 && std::abs(b - line) < 1e-9;
  };
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (!mesh.is_open(h) && (on_a_line(h, 0) || on_a_line(h, 1))) mesh.cut(h, 0);
  }
  return mesh;
}

TEST(CrackDistance, IsTheSameOnAnyNumberOfThreads) {
  const TriangleMesh mesh = tiles();
  ASSERT_EQ(find_components(mesh).count, 36);
  const NearbyCracks one = nearby_cracks(mesh, crack_sides(mesh), infinity, {1, {}, {}});
  ASSERT_GT(one.segments.size(), 3U * static_cast<std::size_t>(mesh.face_count()));
  for (const int threads : {2, 3, 64}) {
    const NearbyCracks many = nearby_cracks(mesh, crack_sides(mesh), infinity, {threads, {}, {}});
    EXPECT_EQ(many.first, one.first);
    ASSERT_EQ(many.segments.size(), one.segments.size());
    for (std::size_t i = 0; i < one.segments.size(); ++i) {
      EXPECT_EQ(many.segments[i].halfedge, one.segments[i].halfedge);
      EXPECT_EQ(many.segments[i].a, one.segments[i].a);
      EXPECT_EQ(many.segments[i].b, one.segments[i].b);
    }
  }
}

TEST(CrackDistance, SaysHowFarItIsAndHearsACancel) {
  const TriangleMesh mesh = tiles();
  double fraction = -1;
  Context context{2,
                  [&](const Progress& p) {
                    EXPECT_GE(p.fraction, fraction);
                    fraction = p.fraction;
                  },
                  {}};
  nearby_cracks(mesh, crack_sides(mesh), infinity, context);
  EXPECT_EQ(fraction, 1);
  fraction = -1;
  context.cancelled = [] { return true; };
  EXPECT_THROW(nearby_cracks(mesh, crack_sides(mesh), infinity, context), Cancelled);
}

TEST(CrackDistance, WithoutCracksEveryVertexIsBeyondReach) {
  const TriangleMesh mesh = plate(3, 0);
  for (const double d : crack_distances(mesh, 7, {})) EXPECT_EQ(d, 7);
}

}  // namespace
}  // namespace craze
