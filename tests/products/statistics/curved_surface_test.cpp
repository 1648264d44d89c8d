// Crack graphs on curved surfaces, where angles and sides obey Gauss–Bonnet.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "craze/products/statistics/measures/cells.h"
#include "craze/products/statistics/measures/junction_angles.h"
#include "craze/products/statistics/null_models/null_models.h"
#include "craze/products/statistics/statistics.h"

namespace craze {
namespace {

using std::numbers::pi;

/// The edges of a polyhedron whose vertices are the nearest neighbours of each other, drawn on its
/// circumscribed unit sphere as arcs of `pieces` pieces, or on its own flat faces.
CrackGraphInput edges_of(const std::vector<Vec3>& vertices, int pieces, bool on_sphere) {
  double shortest = 10;
  for (const Vec3& a : vertices) {
    for (const Vec3& b : vertices) {
      if (&a != &b) shortest = std::min(shortest, (a - b).norm());
    }
  }
  LineSet set;
  Attribute normal{"normal", 3, {}};
  const auto add = [&](Vec3 p, const Vec3& n) {
    set.points.push_back(p);
    for (int k = 0; k < 3; ++k) normal.values.push_back(n[k]);
    return static_cast<std::int32_t>(set.points.size()) - 1;
  };
  for (const Vec3& v : vertices) add(on_sphere ? Vec3(v.normalized()) : v, v.normalized());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t j = i + 1; j < vertices.size(); ++j) {
      if ((vertices[i] - vertices[j]).norm() > 1.01 * shortest) continue;
      auto last = static_cast<std::int32_t>(i);
      for (int k = 1; k <= pieces; ++k) {
        const Vec3 p =
            vertices[i] + (vertices[j] - vertices[i]) * (static_cast<double>(k) / pieces);
        // On a flat-faced body the normal of an edge is that of its middle.
        const Vec3 n = (on_sphere ? p : Vec3(vertices[i] + vertices[j])).normalized();
        const std::int32_t next =
            k == pieces ? static_cast<std::int32_t>(j) : add(on_sphere ? n : p, n);
        set.edges.push_back({last, next});
        last = next;
      }
    }
  }
  set.point_attributes.push_back(normal);
  return graph_from_lines(set);
}

std::vector<Vec3> cube() {
  std::vector<Vec3> v;
  for (int i = 0; i < 8; ++i) v.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  return v;
}

std::vector<Vec3> dodecahedron() {
  std::vector<Vec3> v = cube();
  const double g = std::numbers::phi;
  for (const double a : {-1 / g, 1 / g}) {
    for (const double b : {-g, g}) {
      v.emplace_back(0, a, b);
      v.emplace_back(a, b, 0);
      v.emplace_back(b, 0, a);
    }
  }
  return v;
}

TEST(CurvedSurface, ADodecahedronOnTheSphereIsAHoneycombBentByItsCurvature) {
  const Statistics s = compute_statistics(edges_of(dodecahedron(), 24, true));
  EXPECT_EQ(s.cells, 12);
  EXPECT_EQ(s.junctions, 20);
  EXPECT_NEAR(s.y_fraction.value, 1, 1e-12);
  EXPECT_NEAR(s.angle_max.value, 120, 0.01);
  EXPECT_NEAR(s.sides.value, 5, 1e-12);
  EXPECT_NEAR(s.curvature.value, 4 * pi / 12, 1e-9);
  EXPECT_NEAR(s.sides_flat.value, 6, 1e-9);
  EXPECT_NEAR(s.sides_from_nodes.value, 6, 1e-9);
  // The fan misses the dome of the cell: 1 − ρ²/4 with 4π/12 = 2π (1 − cos ρ).
  const double rho = std::acos(1 - 2.0 / 12);
  EXPECT_NEAR(s.mean_area.value, 4 * pi / 12 * (1 - rho * rho / 4), 0.03);
}

TEST(CurvedSurface, ACubesEdgesMeetAtAHundredAndTwentyDegreesOnceRescaled) {
  for (const bool on_sphere : {true, false}) {
    const Statistics s = compute_statistics(edges_of(cube(), 16, on_sphere));
    EXPECT_EQ(s.cells, 6);
    EXPECT_NEAR(s.angle_min.value, 120, 0.01);
    EXPECT_NEAR(s.angle_max.value, 120, 0.01);
    EXPECT_NEAR(s.sides.value, 4, 1e-12);
    EXPECT_NEAR(s.curvature.value, 4 * pi / 6, 1e-9);
    EXPECT_NEAR(s.sides_flat.value, 6, 1e-9);
    if (!on_sphere) {
      EXPECT_NEAR(s.mean_area.value, 4, 1e-9);
    }
  }
}

TEST(CurvedSurface, TheCurvatureOfAllCellsIsThatOfTheWholeHoweverTheyAreShaped) {
  // A random planar pattern wrapped over the lower part of a sphere by stereographic projection,
  // its border being the last cell.
  CrackGraphInput graph = null_graph(NullModel::poisson_voronoi, 80, 11);
  const double side = std::sqrt(80.0);
  for (std::size_t i = 0; i < graph.points.size(); ++i) {
    const Vec2 q = (graph.points[i].head<2>() - Vec2::Constant(side / 2)) * (4 / side);
    const double d = 1 + q.squaredNorm();
    graph.points[i] = Vec3(2 * q.x() / d, 2 * q.y() / d, (q.squaredNorm() - 1) / d);
    graph.normals[i] = -graph.points[i];  // seen from inside, so that the order is kept
  }
  graph.surface_area = 0;
  for (GraphInputEdge& e : graph.edges) e.border = false;
  CrackGraph map(graph);
  map.remove_dead_ends();
  const auto sectors = all_sector_angles(map, {0.01, 0.1});
  double curvature = 0;
  const auto cells = find_cells(map, sectors, 0.3, {}, std::nullopt);
  for (const Cell& c : cells) curvature += c.curvature;
  // Cells found plus the outer one make a sphere.
  EXPECT_EQ(cells.size(), map.trace_faces().size());
  EXPECT_NEAR(curvature, 4 * pi, 1e-6);
}

RC_GTEST_PROP(CurvedSurface, TurningAPlateInSpaceChangesNothing, ()) {
  CrackGraphInput graph = null_graph(NullModel::stit, 100, 5);
  StatisticsOptions o;
  o.bootstrap.resamples = 0;
  const Statistics flat = compute_statistics(graph, o);
  const auto number = [] { return *rc::gen::inRange(-1000, 1001) / 1000.0; };
  const Eigen::Quaterniond q =
      Eigen::Quaterniond(number(), number(), number(), 1.001 + number()).normalized();
  for (Vec3& p : graph.points) p = q * p + Vec3(1, 2, 3);
  for (Vec3& n : graph.normals) n = q * n;
  const Statistics turned = compute_statistics(graph, o);
  RC_ASSERT(turned.cells == flat.cells);
  RC_ASSERT(turned.cells_found == flat.cells_found);
  RC_ASSERT(std::abs(turned.circularity.value - flat.circularity.value) < 0.02);
  RC_ASSERT(std::abs(turned.leg_younger.value - 1) < 0.02);
}

}  // namespace
}  // namespace craze
