#include "craze/products/opening/curl.h"

#include <gtest/gtest.h>

#include "craze/products/opening/opening.h"
#include "products/distance/surfaces.h"

namespace craze {
namespace {

/// A plate with a crack along y = 0.5.
TriangleMesh plate_with_crack(int n) {
  TriangleMesh mesh = test::plate(n, 0);
  const auto on_line = [&](std::int32_t v) { return std::abs(mesh.position(v).y() - 0.5) < 1e-9; };
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (!mesh.is_open(h) && on_line(mesh.from(h)) && on_line(mesh.to(h))) mesh.cut(h, 0);
  }
  return mesh;
}

TEST(Curl, FadesExponentiallyOverItsLengthWhateverTheTriangles) {
  const double length = 0.1;
  for (const int n : {40, 80}) {
    const TriangleMesh mesh = plate_with_crack(n);
    const std::vector<double> one(mesh.vertex_count(), 1);
    const std::vector<double> lift = curl_lift(mesh, crack_sites(mesh), one, length);
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      // The far border is free: no flux, so the profile is a hyperbolic cosine.
      const double d = std::abs(mesh.position(v).y() - 0.5);
      EXPECT_NEAR(lift[v], std::cosh((0.5 - d) / length) / std::cosh(0.5 / length), 0.02);
    }
  }
}

TEST(Curl, LiftsAlongTheNormalInProportionToTheDisplacement) {
  const TriangleMesh mesh = plate_with_crack(20);
  std::vector<Vec3> u(mesh.vertex_count());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    u[v] = Vec3(0, mesh.position(v).y() < 0.5 ? -0.1 : 0.1, 0);
  }
  const OpenedMesh opened = open_cracks(mesh, u, {.gap = 0.5, .curl = 0.4}, {});
  const CrackSites sites = crack_sites(mesh);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const double lift = opened.mesh.positions[v].z();
    EXPECT_LE(lift, 0.4 * 0.05 + 1e-12);
    EXPECT_TRUE(sites.site_of[v] < 0 || std::abs(lift - 0.4 * 0.05) < 1e-12);
  }
}

TEST(Curl, BelowZeroTheEdgesGoDown) {
  const TriangleMesh mesh = plate_with_crack(20);
  const std::vector<Vec3> u(mesh.vertex_count(), Vec3(0, 0.02, 0));
  const CrackSites sites = crack_sites(mesh);
  const OpenedMesh opened = open_cracks(mesh, u, {.gap = 0.5, .curl = -0.4}, {});
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (sites.site_of[v] < 0) continue;
    EXPECT_NEAR(opened.mesh.positions[v].z(), -0.4 * 0.01, 1e-12);
  }
}

TEST(Curl, WithoutCracksNothingIsLifted) {
  const TriangleMesh mesh = test::plate(4, 0);
  const CrackSites sites = crack_sites(mesh);
  EXPECT_EQ(natural_curl_length(mesh, sites), 0);
  for (const double l : curl_lift(mesh, sites, std::vector<double>(mesh.vertex_count(), 1), 1)) {
    EXPECT_EQ(l, 0);
  }
}

}  // namespace
}  // namespace craze
