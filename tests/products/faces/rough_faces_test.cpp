// post.face_roughness: walls that are rough in depth.
#include "craze/products/faces/rough_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "craze/engine/cracked_surface.h"
#include "craze/engine/roughness/crack_chains.h"
#include "craze/error.h"
#include "craze/mesh/self_intersection.h"
#include "craze/products/faces/face_field.h"
#include "craze/products/opening/opened_surface.h"
#include "products/solids/solid_checks.h"

namespace craze {
namespace {

/// A shape cracked with rough lines.
Result rough_run(const std::string& shape, double spacing, double roughness = 0.06,
                 std::uint64_t seed = 1, OutputMesh output = OutputMesh::asset) {
  Recipe recipe = read_preset("mud");
  recipe.mesh.output = output;
  recipe.simulation.layer.relative_spacing = spacing;
  recipe.simulation.seed = seed;
  recipe.post.relative_roughness = roughness;
  Input input;
  input.surface = std::make_shared<const SurfaceMesh>(make_shape(shape));
  return crack(std::move(input), recipe, {}, {});
}

PostParameters faces_of(const Result& run, double gap, double wall, double thickness,
                        double face_roughness = 1) {
  PostParameters post = run.report().recipe.post;
  post.gap = gap;
  post.wall = wall;
  post.thickness = thickness;
  post.face_roughness = face_roughness;
  return post;
}

/// Slope of a straight line through points (log x, log y).
double power_of(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double a = std::log(x[i]), b = std::log(y[i]);
    n += 1;
    sx += a;
    sy += b;
    sxx += a * a;
    sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TEST(FaceField, IsSelfAffineWithTheExponentAndTheAmplitudeOverTwoDecades) {
  for (const double exponent : {0.3, 0.5, 0.8}) {
    FaceFieldOptions options{0.05, 2, exponent, 1, 0.005, 7};
    const FaceField field(options);
    FaceField::Memory memory;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-20, 20);
    std::normal_distribution<double> normal;
    std::vector<double> lags, differences;
    for (double lag = 0.005; lag <= 0.5001; lag *= std::sqrt(10.0)) {
      double sum = 0;
      constexpr int pairs = 3000;
      for (int i = 0; i < pairs; ++i) {
        const Vec3 p(place(random), place(random), place(random));
        const Vec3 way(normal(random), normal(random), normal(random));
        const double d = field.at(p + lag * way.normalized(), memory) - field.at(p, memory);
        sum += d * d;
      }
      lags.push_back(lag);
      differences.push_back(std::sqrt(sum / pairs));
      if (lag > 0.01 && lag < 0.1) {
        const double wanted = options.amplitude * std::pow(lag / options.usual, exponent);
        EXPECT_NEAR(differences.back(), wanted, 0.1 * wanted) << lag;
      }
    }
    EXPECT_NEAR(power_of(lags, differences), exponent, 0.05);
  }
}

/// The heights of the points of each upright line of walls that is not near the end of a crack.
std::vector<std::vector<double>> upright_profiles(const OpenedSurface& surface) {
  const OpenedMesh& opened = surface.opened;
  std::vector<std::vector<double>> profiles;
  const std::vector<WallPoint>& points = opened.wall_points;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t end = i;
    while (end < points.size() && points[end].top == points[i].top &&
           points[end].bottom == points[i].bottom) {
      ++end;
    }
    const bool is_upright = opened.vertex_of[points[i].top] == opened.vertex_of[points[i].bottom];
    if (is_upright && points[i].aside.norm() > 0) {
      const Vec3 way = points[i].aside.normalized();
      std::vector<double> heights{0};
      for (std::size_t k = i; k < end; ++k) heights.push_back(points[k].aside.dot(way));
      heights.push_back(0);
      profiles.push_back(std::move(heights));
    }
    i = end;
  }
  return profiles;
}

TEST(RoughFaces, HaveTheExponentAndTheAmplitudeOfTheirLinesInDepth) {
  const Result run = rough_run("plate?n=40&jitter=0.3", 0.25, 0.04);
  for (const double exponent : {0.6, 0.8}) {
    const double depth = 0.12;
    PostParameters post = faces_of(run, 0, 0, depth);
    post.roughness_exponent = exponent;
    post.roughness_step = depth / 64;
    const Opening opening(run, post, {});
    const double usual = usual_length(crack_chains(run.state().network));
    const auto profiles = upright_profiles(opening.surface());
    ASSERT_GT(profiles.size(), 500U);
    std::vector<double> lags, differences;
    for (std::size_t lag = 1; lag <= 16; lag *= 2) {
      double sum = 0, count = 0;
      for (const std::vector<double>& h : profiles) {
        ASSERT_EQ(h.size(), 65U);
        for (std::size_t k = 0; k + lag < h.size(); ++k) {
          sum += (h[k + lag] - h[k]) * (h[k + lag] - h[k]);
          ++count;
        }
      }
      lags.push_back(depth / 64 * static_cast<double>(lag));
      differences.push_back(std::sqrt(sum / count));
      // Less near the ends of cracks.
      const double wanted = post.roughness * std::pow(lags.back() / usual, exponent);
      EXPECT_LT(differences.back(), 1.1 * wanted) << lag;
      EXPECT_GT(differences.back(), 0.7 * wanted) << lag;
    }
    EXPECT_NEAR(power_of(lags, differences), exponent, 0.05);
  }
}

TEST(RoughFaces, OfSolidsAreClosedAndDoNotMeet) {
  for (const char* shape : {"plate?n=20&jitter=0.3", "cup?n=24", "sphere?n=14", "cube"}) {
    for (const std::uint64_t seed : {1, 2}) {
      const Result run = rough_run(shape, 0.2, 0.06, seed);
      for (const double gap : {0.0, 0.05}) {
        SCOPED_TRACE(std::string(shape) + ", seed " + std::to_string(seed) + ", gap " +
                     std::to_string(gap));
        const Opening flat(run, faces_of(run, gap, 0, 0.04, 0), {});
        const Opening rough(run, faces_of(run, gap, 0, 0.04, 2), {});
        EXPECT_GT(rough.mesh().triangles.size(), flat.mesh().triangles.size());
        double whole = 0, whole_flat = 0;
        for (const SurfaceMesh& solid : fragments(rough.mesh())) {
          EXPECT_TRUE(test::is_closed(solid));
          EXPECT_GT(test::volume_of(solid), 0);
          whole += test::volume_of(solid);
        }
        for (const SurfaceMesh& solid : fragments(flat.mesh())) {
          whole_flat += test::volume_of(solid);
        }
        // What one side of a crack gains the other loses.
        EXPECT_NEAR(whole, whole_flat, (gap == 0 ? 1e-9 : 1e-3) * whole_flat);
        EXPECT_TRUE(self_intersections(rough.mesh().positions, rough.mesh().triangles).empty());
      }
    }
  }
}

std::size_t open_edges(const SurfaceMesh& mesh) {
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(edges.emplace(t[i], t[(i + 1) % 3]).second);
    }
  }
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const auto& e) {
    return edges.count({e.second, e.first}) == 0;
  }));
}

std::vector<Vec3> flattened(const OpenedMesh& opened) {
  std::vector<Vec3> flat = opened.mesh.positions;
  std::size_t v = flat.size() - opened.wall_points.size();
  for (const WallPoint& p : opened.wall_points) flat[v++] = p.between(opened.mesh.positions);
  return flat;
}

TEST(RoughFaces, OfGapsCloseThemAsFlatOnesDo) {
  for (const OutputMesh output : {OutputMesh::asset, OutputMesh::simulation}) {
    for (const char* shape : {"sphere?n=14", "cube", "plate?n=20&jitter=0.3", "cup"}) {
      SCOPED_TRACE(shape);
      const Result run = rough_run(shape, 0.2, 0.06, 1, output);
      for (const double roughness : {1.0, 20.0}) {
        PostParameters post = faces_of(run, 0.05, 0.03, 0, roughness);
        post.curl = roughness == 1 ? 0 : 0.5;
        const Opening opening(run, post, {});
        const SurfaceMesh& mesh = opening.mesh();
        post.face_roughness = 0;
        const SurfaceMesh flat = Opening(run, post, {}).mesh();
        EXPECT_EQ(open_edges(mesh), open_edges(flat));
        EXPECT_TRUE(self_intersections(mesh.positions, mesh.triangles).empty());
      }
    }
  }
}

TEST(RoughFaces, OfGapsBesideTipsOnHardEdgesDoNotCross) {
  for (const OutputMesh output : {OutputMesh::asset, OutputMesh::simulation}) {
    for (const char* shape : {"cube", "cup?n=24"}) {
      for (const std::uint64_t seed : {1, 2, 3, 4}) {
        SCOPED_TRACE(std::string(shape) + ", seed " + std::to_string(seed));
        const Result run = rough_run(shape, 0.2, 0.06, seed, output);
        const Opening opening(run, faces_of(run, 0.05, 0.03, 0), {});
        const SurfaceMesh& mesh = opening.mesh();
        EXPECT_TRUE(self_intersections(mesh.positions, mesh.triangles).empty());
        const std::vector<Vec3> flat = flattened(opening.surface().opened);
        EXPECT_TRUE(self_intersections(flat, mesh.triangles).empty());
      }
    }
  }
}

TEST(RoughFaces, FitEachOther) {
  const Result run = rough_run("plate?n=20&jitter=0.3", 0.2);
  const Opening opening(run, faces_of(run, 0, 0, 0.05), {});
  const OpenedMesh& opened = opening.surface().opened;
  std::multiset<std::array<double, 3>> moved;
  const auto first = opened.mesh.positions.size() - opened.wall_points.size();
  for (std::size_t i = 0; i < opened.wall_points.size(); ++i) {
    const Vec3& p = opened.mesh.positions[first + i];
    if (opened.wall_points[i].aside.norm() > 0) moved.insert({p.x(), p.y(), p.z()});
  }
  ASSERT_GT(moved.size(), 1000U);
  for (const auto& p : moved) EXPECT_EQ(moved.count(p), 2U);
}

TEST(RoughFaces, LeaveRimsInnerEdgesAndBordersAsTheyAre) {
  const Result run = rough_run("plate?n=20&jitter=0.3", 0.2);
  for (const double thickness : {0.0, 0.05}) {
    const Opening flat(run, faces_of(run, 0.03, 0.02, thickness, 0), {}),
        rough(run, faces_of(run, 0.03, 0.02, thickness), {});
    const auto& before = flat.mesh().positions;
    ASSERT_LT(before.size(), rough.mesh().positions.size());
    for (std::size_t v = 0; v < before.size(); ++v) EXPECT_EQ(rough.mesh().positions[v], before[v]);
    const OpenedMesh& opened = rough.surface().opened;
    const std::vector<std::int32_t>& sites = rough.surface().times.sites.site_of;
    for (const WallPoint& p : opened.wall_points) {
      EXPECT_TRUE(sites[opened.vertex_of[p.top]] >= 0 || p.aside.isZero(0));
    }
  }
}

TEST(RoughFaces, AreTheSameOnAnyNumberOfThreads) {
  const Result run = rough_run("sphere?n=14", 0.2);
  Context three;
  three.threads = 3;
  const PostParameters post = faces_of(run, 0.05, 0, 0.03);
  EXPECT_EQ(Opening(run, post, three).mesh().positions, Opening(run, post, {}).mesh().positions);
}

TEST(RoughFaces, GrowWithTheirCracks) {
  const Result run = rough_run("plate?n=16", 0.25);
  for (const double thickness : {0.0, 0.03}) {
    const Opening opening(run, faces_of(run, 0.05, 0.03, thickness), {});
    const GrowthClip clip(opening);
    const SurfaceMesh& mesh = opening.mesh();
    for (const double time : {0.0, 0.5, 1.0}) {
      const std::vector<Vec3> at = clip.positions_at(time);
      ASSERT_EQ(at.size(), mesh.positions.size());
      double apart = 0, lowest = 0;
      for (std::size_t v = 0; v < at.size(); ++v) {
        ASSERT_TRUE(at[v].allFinite());
        apart = std::max(apart, (at[v] - mesh.positions[v]).norm());
        lowest = std::min(lowest, at[v].z());
      }
      if (time == 1) {
        EXPECT_LT(apart, 1e-12);
      } else {
        EXPECT_GT(apart, 1e-3);
      }
      EXPECT_GE(lowest, -0.03 - 1e-9);
    }
  }
}

TEST(RoughFaces, SayWhatTheyLack) {
  const Result smooth = rough_run("plate?n=16", 0.25, 0);
  const auto warned = [&](const PostParameters& post) {
    const Opening opening(smooth, post, {});
    EXPECT_TRUE(opening.surface().opened.wall_points.empty());
    const auto& said = opening.warnings();
    return std::count_if(said.begin(), said.end(), [](const std::string& warning) {
      return warning.find("post.face_roughness") != std::string::npos;
    });
  };
  EXPECT_EQ(warned(faces_of(smooth, 0.05, 0.03, 0)), 1);  // no roughness
  EXPECT_EQ(warned(faces_of(smooth, 0.05, 0, 0)), 1);     // no walls
  EXPECT_EQ(warned(faces_of(smooth, 0.05, 0.03, 0, 0)), 0);
}

TEST(RoughFaces, SayWhatIsNotSeenAndWhichRowsAreFewer) {
  const Result run = rough_run("plate?n=16", 0.25);
  const auto said = [&](double gap, double face_roughness, double step = 0, double wall = 0.1) {
    PostParameters post = faces_of(run, gap, wall, 0, face_roughness);
    post.roughness_step = step;
    std::string all;
    const Opening opening(run, post, {});
    for (const std::string& warning : opening.warnings()) {
      if (warning.find("post.face_roughness") != std::string::npos ||
          warning.find("post.roughness_step") != std::string::npos) {
        all += warning + "\n";
      }
    }
    return all;
  };
  EXPECT_EQ(said(0.02, 1), "");
  EXPECT_NE(said(0, 1).find("cracks are shut"), std::string::npos);
  EXPECT_EQ(said(0, 0), "");
  EXPECT_NE(said(0.02, 10, 0.005).find("steeper than 45 degrees"), std::string::npos);
  EXPECT_NE(said(0.02, 1, 1e-4).find("at most 64 rows and 1048576 triangles"), std::string::npos);
  EXPECT_EQ(said(0.02, 0, 1e-4), "");
}

TEST(RoughFaces, BelowChippedRimsAreSoundToo) {
  for (const char* shape : {"plate?n=20&jitter=0.3", "sphere?n=14"}) {
    const Result run = rough_run(shape, 0.2);
    for (const double thickness : {0.0, 0.05}) {
      PostParameters post = faces_of(run, 0.05, 0.03, thickness);
      post.chipping = 0.4;
      const SurfaceMesh mesh = Opening(run, post, {}).mesh();
      EXPECT_TRUE(self_intersections(mesh.positions, mesh.triangles).empty());
      if (thickness == 0) continue;
      for (const SurfaceMesh& solid : fragments(mesh)) {
        EXPECT_TRUE(test::is_closed(solid));
        EXPECT_GT(test::volume_of(solid), 0);
      }
    }
  }
}

TEST(RoughFaces, AreHeldBackWhereTheyWouldCross) {
  const Result run = rough_run("sphere?n=14", 0.2, 0.3);
  for (const double roughness : {1.0, 1e6, 1e300}) {
    PostParameters post = faces_of(run, 0.05, 0, 0.2, roughness);
    const SurfaceMesh mesh = Opening(run, post, {}).mesh();
    for (const SurfaceMesh& solid : fragments(mesh)) {
      EXPECT_TRUE(test::is_closed(solid));
      EXPECT_GT(test::volume_of(solid), 0);
    }
    EXPECT_TRUE(self_intersections(mesh.positions, mesh.triangles).empty());
  }
}

}  // namespace
}  // namespace craze
