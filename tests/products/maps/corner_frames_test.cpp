#include "craze/mesh/corner_frames.h"

#include <gtest/gtest.h>

#include "plates.h"

namespace craze {
namespace {

TEST(CornerFrames, OfAPlateAreItsAxes) {
  const SurfaceMesh plate = plate_with(3, {}).surface;
  const std::vector<Vec3> normals = corner_normals(plate);
  const CornerTangents tangents = corner_tangents(plate, normals);
  for (std::size_t c = 0; c < normals.size(); ++c) {
    EXPECT_LT((normals[c] - Vec3::UnitZ()).norm(), 1e-14);
    EXPECT_LT((tangents.tangent[c] - Vec3::UnitX()).norm(), 1e-14);
    EXPECT_EQ(tangents.handed[c / 3], 1);
  }
}

TEST(CornerFrames, OfMirroredUvsAreLeftHanded) {
  SurfaceMesh plate = plate_with(3, {}).surface;
  for (Vec2& uv : plate.corner_uvs) uv.x() = 1 - uv.x();
  const CornerTangents tangents = corner_tangents(plate, corner_normals(plate));
  for (std::size_t c = 0; c < tangents.tangent.size(); ++c) {
    EXPECT_LT((tangents.tangent[c] + Vec3::UnitX()).norm(), 1e-14);
    EXPECT_EQ(tangents.handed[c / 3], -1);
  }
}

TEST(CornerFrames, SmoothARoundSurfaceAndKeepTheEdgesOfACube) {
  SurfaceMesh sphere = make_shape("sphere?n=12");
  sphere.corner_normals.clear();
  const std::vector<Vec3> smooth = corner_normals(sphere);
  for (std::size_t c = 0; c < smooth.size(); ++c) {
    const Vec3& p = sphere.positions[sphere.triangles[c / 3][c % 3]];
    EXPECT_GT(smooth[c].dot(p.normalized()), 0.99);
  }
  SurfaceMesh cube = make_shape("cube");
  cube.corner_normals.clear();
  for (const Vec3& n : corner_normals(cube)) EXPECT_NEAR(n.cwiseAbs().maxCoeff(), 1, 1e-12);
}

TEST(CornerFrames, AreAtRightAnglesToTheNormal) {
  const SurfaceMesh cup = make_shape("cup");
  const std::vector<Vec3> normals = corner_normals(cup);
  const CornerTangents tangents = corner_tangents(cup, normals);
  for (std::size_t c = 0; c < normals.size(); ++c) {
    EXPECT_NEAR(tangents.tangent[c].dot(normals[c]), 0, 1e-12);
    EXPECT_NEAR(tangents.tangent[c].norm(), 1, 1e-12);
  }
}

}  // namespace
}  // namespace craze
