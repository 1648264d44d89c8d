#include "craze/mesh/atlas/uv_atlas.h"

#include <gtest/gtest.h>

#include <cmath>

#include "craze/shapes.h"

namespace craze {
namespace {

SurfaceMesh without_uvs(const char* shape) {
  SurfaceMesh mesh = make_shape(shape);
  mesh.corner_uvs.clear();
  return mesh;
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// The lengths on a face of the longest and the shortest unit vector of the UVs.
std::pair<double, double> stretch(const SurfaceMesh& mesh, const std::vector<Vec2>& uvs,
                                  std::size_t f) {
  const Vec3& p = mesh.positions[mesh.triangles[f][0]];
  Eigen::Matrix<double, 3, 2> lengths;
  lengths << mesh.positions[mesh.triangles[f][1]] - p, mesh.positions[mesh.triangles[f][2]] - p;
  Mat2 flat;
  flat << uvs[3 * f + 1] - uvs[3 * f], uvs[3 * f + 2] - uvs[3 * f];
  const Eigen::Matrix<double, 3, 2> by_uv = lengths * flat.inverse();
  const Mat2 squares = by_uv.transpose() * by_uv;
  const double mean = squares.trace() / 2;
  const double spread = std::sqrt(std::max(0.0, mean * mean - squares.determinant()));
  return {std::sqrt(mean - spread), std::sqrt(mean + spread)};
}

const char* const shapes[] = {"cube?n=4", "sphere?n=16", "torus?n=24", "cup?n=24",
                              "plate?n=8&jitter=0.3"};

TEST(UvAtlas, HasBoundedStretchAtOneScale) {
  for (const char* shape : shapes) {
    const SurfaceMesh mesh = without_uvs(shape);
    const std::vector<Vec2> uvs = uv_atlas(mesh, {}, {});
    double least = INFINITY, most = 0;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      const auto [low, high] = stretch(mesh, uvs, f);
      least = std::min(least, low);
      most = std::max(most, high);
    }
    EXPECT_LE(most, most_atlas_stretch * least * (1 + 1e-6)) << shape;
  }
}

TEST(UvAtlas, LaysNoTriangleOverAnotherAndAllInTheUnitSquare) {
  const int size = 700;
  for (const char* shape : shapes) {
    const SurfaceMesh mesh = without_uvs(shape);
    const std::vector<Vec2> uvs = uv_atlas(mesh, {}, {});
    std::vector<int> covered(size * size, 0);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      const Vec2 &a = uvs[3 * f], &b = uvs[3 * f + 1], &c = uvs[3 * f + 2];
      ASSERT_GT(turn(a, b, c), 0) << shape;
      const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
      ASSERT_GE(low.minCoeff(), 0) << shape;
      ASSERT_LE(high.maxCoeff(), 1) << shape;
      for (int y = static_cast<int>(low.y() * size); y <= high.y() * size && y < size; ++y) {
        for (int x = static_cast<int>(low.x() * size); x <= high.x() * size && x < size; ++x) {
          const Vec2 p((x + 0.5) / size, (y + 0.5) / size);
          constexpr double inside = 1e-9;
          if (turn(a, b, p) > inside && turn(b, c, p) > inside && turn(c, a, p) > inside) {
            ++covered[y * size + x];
          }
        }
      }
    }
    int any = 0;
    for (const int times : covered) {
      ASSERT_LE(times, 1) << shape;
      any += times;
    }
    EXPECT_GT(any, size * size / 3) << shape << ": most of the square is empty";
  }
}

TEST(UvAtlas, IsTheSameWhetherTrianglesShareTheirVerticesOrNot) {
  const SurfaceMesh mesh = without_uvs("cup?n=24");
  SurfaceMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::int32_t>(soup.positions.size());
    for (const std::int32_t v : t) soup.positions.push_back(mesh.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(uv_atlas(mesh, {}, {}), uv_atlas(soup, {}, {}));
}

TEST(UvAtlas, LeavesOutWhatIsNotWantedOrHasNoArea) {
  SurfaceMesh mesh = without_uvs("plate?n=4");
  mesh.triangles.push_back({0, 1, 1});
  std::vector<char> wanted(mesh.triangles.size(), 1);
  wanted[3] = 0;
  const std::vector<Vec2> uvs = uv_atlas(mesh, wanted, {});
  for (const std::size_t f : {std::size_t{3}, mesh.triangles.size() - 1}) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(uvs[3 * f + i].isZero());
  }
  EXPECT_GT(turn(uvs[0], uvs[1], uvs[2]), 0);
}

TEST(UvAtlas, PartsWhatWouldLieOverItselfThoughItIsFlat) {
  // A strip that climbs around an axis twice: every normal points nearly along it.
  SurfaceMesh mesh;
  const int steps = 80;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 4 * M_PI * i / steps;
    for (const double r : {1.0, 2.0}) {
      mesh.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.02 * i);
    }
    if (i == steps) break;
    mesh.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
    mesh.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
  }
  const std::vector<Vec2> uvs = uv_atlas(mesh, {}, {});
  const auto middle = [&](std::size_t f) -> Vec2 {
    return (uvs[3 * f] + uvs[3 * f + 1] + uvs[3 * f + 2]) / 3;
  };
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t g = 0; g < mesh.triangles.size(); ++g) {
      if (f == g) continue;
      const Vec2 p = middle(g);
      const bool is_in = turn(uvs[3 * f], uvs[3 * f + 1], p) > 0 &&
                         turn(uvs[3 * f + 1], uvs[3 * f + 2], p) > 0 &&
                         turn(uvs[3 * f + 2], uvs[3 * f], p) > 0;
      ASSERT_FALSE(is_in) << f << " " << g;
    }
  }
}

}  // namespace
}  // namespace craze
