#include "craze/model/sources/surface_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "craze/error.h"
#include "craze/mesh/tangent_frame.h"
#include "model/analytic_surfaces.h"
#include "model/states.h"

// Worst relative error of the distance at the faces, beyond 0.1 from the source, unit sphere
// (jitter 0.1):   512: .044   2,048: .026   8,192: .013   32,768: .006   73,728: .005

namespace craze {
namespace {

PointOnSurface nearest(const TriangleMesh& mesh, const Vec3& p) {
  return closest_surface_point(mesh, p, Context{});
}

void expect_straight(const TriangleMesh& mesh, const Vec3& from, double tolerance) {
  const PointOnSurface source = nearest(mesh, from);
  const SurfaceDistance d = surface_distance(mesh, source, {});
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Vec3 ray = test::centroid(mesh, f) - source.position;
    EXPECT_NEAR(d.face[f], ray.norm(), tolerance * ray.norm());
    EXPECT_GT((tangent_frame(mesh, f) * d.direction[f]).dot(ray.normalized()), 1 - tolerance);
  }
}

TEST(SurfaceDistance, IsStraightOnAPlateWhateverTheTriangles) {
  expect_straight(test::plate(10, 1, 0), {0.11, 0.07, 0.01}, 1e-4);
  expect_straight(test::plate(40, 1, 0.24), {0.11, 0.07, 0.01}, 1e-4);
  expect_straight(test::plate(11, 1, 0), {0.5, 0.5, 0}, 1e-4);  // from a corner of the plate
  const auto slivers = test::grid_surface(6, 90, false, false, 0.24, 1,
                                          [](double s, double t) { return Vec3(s, t, 0); });
  expect_straight(slivers, {0.61, 0.57, 0}, 1e-3);
}

TEST(SurfaceDistance, FollowsTheSphereNotTheChord) {
  double last = 1;
  const int resolutions[] = {8, 16, 32};
  for (const int n : resolutions) {
    const TriangleMesh mesh = test::sphere(n, 1, 0.1);
    const PointOnSurface source = nearest(mesh, {0.3, 0.5, 0.9});
    const SurfaceDistance d = surface_distance(mesh, source, {});
    double worst = 0;
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      const Vec3 c = test::centroid(mesh, f);
      const double exact = std::atan2(c.cross(source.position).norm(), c.dot(source.position));
      if (exact > 0.1) worst = std::max(worst, std::abs(d.face[f] - exact) / exact);
    }
    EXPECT_LT(worst, 0.7 * last);
    last = worst;
  }
  EXPECT_LT(last, 0.015);
}

TEST(SurfaceDistance, RunsAroundATubeNotThroughIt) {
  const TriangleMesh mesh = test::cylinder(120, 1, 0.1);
  const PointOnSurface source = nearest(mesh, {1, 0, 0.5});
  const SurfaceDistance d = surface_distance(mesh, source, {});
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& p = mesh.position(v);
    const double angle = std::atan2(p.y(), p.x());
    EXPECT_NEAR(d.vertex[v], std::hypot(angle, p.z() - 0.5), 0.02);
  }
}

TEST(SurfaceDistance, GoesAroundAHole) {
  // A plate with a slot: the cells with |x| < 0.1, y < 0.25 left out.
  const TriangleMesh whole = test::plate(40, 1, 0);
  std::vector<Triangle> kept;
  for (std::int32_t f = 0; f < whole.face_count(); ++f) {
    const Vec3 c = test::centroid(whole, f);
    if (std::abs(c.x()) > 0.1 || c.y() > 0.25) kept.push_back(whole.triangle(f));
  }
  const TriangleMesh mesh(whole.positions(), kept);
  const SurfaceDistance d = surface_distance(mesh, nearest(mesh, {-0.3, -0.25, 0}), {});
  const std::int32_t target = nearest(mesh, {0.3, -0.25, 0}).face;
  const double exact = 2 * std::hypot(0.2, 0.5) + 0.2;
  EXPECT_NEAR(d.face[target], exact, 0.02);
}

TEST(SurfaceDistance, StopsAtItsReachAndAtTheEdgeOfAComponent) {
  const TriangleMesh mesh = test::plate(20, 1, 0.1);
  const SurfaceDistance d = surface_distance(mesh, nearest(mesh, {0, 0, 0}), {}, 0.2);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(std::isfinite(d.vertex[v]), mesh.position(v).norm() <= 0.2) << v;
  }
}

TEST(SurfaceDistance, APointFarFromTheSurfaceIsRefusedAndToldHowFarItIs) {
  const TriangleMesh mesh = test::sphere(6, 1, 0);
  EXPECT_NO_THROW(require_surface_point(mesh, {0, 0, 1.2}, "impact 1", Context{}));
  try {
    require_surface_point(mesh, {0, 0, 2}, "impact 1", Context{});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::request);
    EXPECT_EQ(
        std::string(e.what()).rfind("point is not on the surface (impact 1): (0 0 2) is 1 ", 0), 0u)
        << e.what();
  }
}

}  // namespace
}  // namespace craze
