#include "craze/render/camera.h"

#include <gtest/gtest.h>

#include "craze/shapes.h"

namespace craze::render {
namespace {

/// A sheet of 20 × 20 quads whose point (x, y) of the unit square is place(x, y).
template <class Place>
SurfaceMesh sheet(Place&& place) {
  SurfaceMesh mesh;
  constexpr int n = 20;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) mesh.positions.push_back(place(i / double{n}, j / double{n}));
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, c = a + n + 1;
      mesh.triangles.push_back({a, a + 1, c + 1});
      mesh.triangles.push_back({a, c + 1, c});
    }
  }
  return mesh;
}

Camera camera_of(const SurfaceMesh& mesh, const View& view = {}) {
  return frame(subject_of(mesh), view, 4 / 3.0);
}

TEST(Camera, SeesTheFrontOfASheetHoweverItLiesOrStands) {
  const auto relief = [](double x, double y) { return 0.1 * std::sin(9 * x) * std::cos(7 * y); };
  const SurfaceMesh sheets[] = {
      sheet([](double x, double y) { return Vec3(x, y, 0); }),
      sheet([](double x, double y) { return Vec3(y, x, 0); }),  // faces down
      sheet([](double x, double y) { return Vec3(x, 0, y); }),
      sheet([](double x, double y) { return Vec3(y, 0, x); }),
      sheet([](double x, double y) { return Vec3(0, x, y); }),
      sheet([](double x, double y) { return Vec3(0, y, x); }),
      sheet([&](double x, double y) { return Vec3(x, y, relief(x, y)); }),
      sheet([&](double x, double y) { return Vec3(y, x, relief(x, y)); }),
      sheet([&](double x, double y) { return Vec3(x, relief(x, y), y); }),
      sheet([&](double x, double y) { return Vec3(y, relief(x, y), x); }),
      sheet([&](double x, double y) { return Vec3(relief(x, y), x, y); }),
  };
  for (const SurfaceMesh& mesh : sheets) {
    const Subject subject = subject_of(mesh);
    const Camera camera = camera_of(mesh);
    EXPECT_LT(camera.forward.dot(subject.facing.normalized()), -0.3)
        << subject.facing.transpose() << ", looking along " << camera.forward.transpose();
  }
}

TEST(Camera, SeesTheBroadSideOfASlabThatStands) {
  SurfaceMesh slab = make_shape("cube?n=4");
  for (Vec3& p : slab.positions) p.x() *= 0.05;
  const Camera camera = camera_of(slab);
  EXPECT_GT(std::abs(camera.forward.x()), 0.7);
}

TEST(Camera, AGivenAxisAndAzimuthAreTaken) {
  const SurfaceMesh down = sheet([](double x, double y) { return Vec3(y, x, 0); });
  View view;
  view.up = UpAxis::z;
  view.azimuth = 0;
  const Camera camera = camera_of(down, view);
  EXPECT_EQ(camera.vertical, Vec3(0, 0, 1));
  EXPECT_NEAR(camera.right.x(), 1, 1e-12);
}

TEST(Camera, StrayTrianglesDoNotPullItOff) {
  const SurfaceMesh cube = make_shape("cube?n=6");
  SurfaceMesh with_strays = cube;
  for (const Vec3& at : {Vec3(40, 3, 0), Vec3(-7, 60, 9)}) {
    const auto first = static_cast<std::int32_t>(with_strays.positions.size());
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0, 0.1, 0)}) {
      with_strays.positions.push_back(at + corner);
    }
    with_strays.triangles.push_back({first, first + 1, first + 2});
  }
  with_strays.positions.emplace_back(-500, 0, 0);  // of no triangle
  const Camera alone = camera_of(cube), beside = camera_of(with_strays);
  EXPECT_LT((alone.eye - beside.eye).norm(), 1e-9 * alone.eye.norm());
}

TEST(Camera, PartsThatBelongToTheWholeAreSeen) {
  // Fragments of a plate, none a hundredth of it; and a lamp that is small but near.
  SurfaceMesh pieces = sheet([](double x, double y) { return Vec3(x, y, 0); });
  SurfaceMesh apart;
  for (const Triangle& t : pieces.triangles) {
    const auto first = static_cast<std::int32_t>(apart.positions.size());
    const Vec3 middle =
        (pieces.positions[t[0]] + pieces.positions[t[1]] + pieces.positions[t[2]]) / 3;
    for (const std::int32_t v : t) {
      apart.positions.push_back(middle + 0.9 * (pieces.positions[v] - middle));
    }
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(subject_of(apart).points.size(), apart.positions.size());
  SurfaceMesh near = pieces;
  const auto first = static_cast<std::int32_t>(near.positions.size());
  for (const Vec3& p : {Vec3(1.05, 0, 0), Vec3(1.06, 0, 0), Vec3(1.05, 0.01, 0)}) {
    near.positions.push_back(p);
  }
  near.triangles.push_back({first, first + 1, first + 2});
  EXPECT_EQ(subject_of(near).points.size(), near.positions.size());
}

}  // namespace
}  // namespace craze::render
