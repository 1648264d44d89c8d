// mesh.output = "asset": the input's own triangles, cracked, and nothing else of it touched.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "craze/base/random.h"
#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/engine/simulation_surface.h"
#include "craze/mesh/closest_point.h"
#include "craze/mesh/components.h"
#include "craze/mesh/validate.h"
#include "craze/presets.h"
#include "craze/products.h"
#include "craze/products/statistics/graph/graph_input.h"
#include "craze/products/statistics/statistics.h"
#include "craze/shapes.h"
#include "craze/surface_origin.h"
#include "engine/asset_cases.h"
#include "engine/cut_checks.h"

namespace craze {
namespace {

Recipe recipe_for(const char* preset, double relative_spacing) {
  Recipe recipe = read_preset(preset);
  recipe.simulation.layer.relative_spacing = relative_spacing;
  return recipe;
}

Result cracked(const SurfaceMesh& mesh, const Recipe& recipe, const CrackOptions& options = {},
               const Context& context = {}) {
  return crack({std::make_shared<const SurfaceMesh>(mesh), {}, "asset"}, recipe, options, context);
}

double area_of(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += test::area_vector(mesh.positions, t).norm() / 2;
  return sum;
}

/// A cube whose edges are cut off at 45 degrees: 6 squares, 12 strips, 8 corners; 44 triangles.
SurfaceMesh bevelled_cube(double bevel) {
  SurfaceMesh mesh;
  // Vertex 3 × corner + axis lies on the square that faces along the axis.
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 p;
      for (int k = 0; k < 3; ++k) {
        p[k] = ((corner >> k & 1) != 0 ? 1 : -1) * (k == axis ? 1 : 1 - bevel);
      }
      mesh.positions.push_back(p);
    }
  }
  const auto add = [&](Triangle t) {
    const Vec3 middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
    if (test::area_vector(mesh.positions, t).dot(middle) < 0) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
  };
  const auto add_quad = [&](int a, int b, int c, int d) {
    add({a, b, c});
    add({a, c, d});
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int x = 1 << axis, y = 1 << (axis + 1) % 3, z = 1 << (axis + 2) % 3;
    for (const int side : {0, x}) {
      add_quad(3 * side + axis, 3 * (side + y) + axis, 3 * (side + y + z) + axis,
               3 * (side + z) + axis);
    }
    for (const int corner : {0, y, z, y + z}) {  // the four edges along the axis
      const int other = (axis + 1) % 3, third = (axis + 2) % 3;
      add_quad(3 * corner + other, 3 * (corner + x) + other, 3 * (corner + x) + third,
               3 * corner + third);
    }
  }
  for (int corner = 0; corner < 8; ++corner) add({3 * corner, 3 * corner + 1, 3 * corner + 2});
  return mesh;
}

struct Asset {
  std::string name;
  SurfaceMesh mesh;
};

std::vector<Asset> hard_edged() {
  return {{"cube", make_shape("cube?n=1")},
          {"bevelled cube", bevelled_cube(0.1)},
          {"cylinder", make_shape("cylinder?n=12")}};
}

TEST(AnAssetsOwnTriangles, KeepTheirPlanesNormalsAreaAndWhatNoCrackTouches) {
  for (const Asset& asset : hard_edged()) {
    SCOPED_TRACE(asset.name);
    const SurfaceMesh mesh = test::dressed(asset.mesh);
    const Result result = cracked(mesh, recipe_for("glaze", 0.1));
    ASSERT_GT(result.report().cracks.fragments, 40);
    EXPECT_EQ(result.report().carried.lost_pieces, 0);
    EXPECT_GT(result.report().simulation.triangles, result.report().input.triangles);
    const SurfaceMesh cut = cut_mesh(result, {});
    EXPECT_TRUE(validate(TriangleMesh(cut.positions, cut.triangles)).empty());
    EXPECT_NEAR(area_of(cut) / area_of(mesh), 1, 1e-9);
    const SurfaceOrigin origin =
        result.state().surface_origin->whole();  // repair changes nothing here
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      EXPECT_EQ(origin.face[f], static_cast<std::int32_t>(f));
    }
    for (std::size_t f = 0; f < cut.triangles.size(); ++f) {
      const Triangle& t = mesh.triangles[cut.source_faces[f]];
      const Vec3 normal = test::area_vector(mesh.positions, t).normalized();
      const Vec3 own = test::area_vector(cut.positions, cut.triangles[f]);
      for (const std::int32_t v : cut.triangles[f]) {
        EXPECT_NEAR((cut.positions[v] - mesh.positions[t[0]]).dot(normal), 0, 1e-9);
      }
      if (own.norm() > 1e-8) {
        EXPECT_LT((own.normalized() - normal).norm(), 1e-6);
      }
    }
    ASSERT_TRUE(
        test::same_bits(cut.positions.data(), mesh.positions.data(), mesh.positions.size()));
    ASSERT_TRUE(test::same_bits(cut.vertex_colors.data(), mesh.vertex_colors.data(),
                                mesh.vertex_colors.size()));
  }
}

TEST(AnAssetsOwnTriangles, ThatNoCrackPassesAreTheInputsToTheBit) {
  SurfaceMesh mesh = test::dressed(make_shape("plate?n=8"));
  for (Vec2& uv : mesh.corner_uvs) uv *= 0.3;
  Attribute stress{"pull", 1, {}};
  for (const Vec3& p : mesh.positions) stress.values.push_back(p.x() < 0 ? 1 : 0);
  mesh.vertex_attributes.push_back(stress);
  Recipe recipe = recipe_for("glaze", 0.06);
  recipe.simulation.stress.uniform = 0;
  recipe.simulation.stress.attribute = "pull";
  const SurfaceMesh cut = cut_mesh(cracked(mesh, recipe), {});
  std::size_t whole = 0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    if (cut.triangles[f] != mesh.triangles[f]) continue;
    ++whole;
    EXPECT_TRUE(test::same_bits(&cut.corner_uvs[3 * f], &mesh.corner_uvs[3 * f], 3));
    EXPECT_TRUE(test::same_bits(&cut.corner_normals[3 * f], &mesh.corner_normals[3 * f], 3));
    EXPECT_EQ(cut.face_materials[f], mesh.face_materials[f]);
  }
  EXPECT_GT(whole, mesh.triangles.size() / 4);
  EXPECT_LT(whole, mesh.triangles.size());
}

Statistics statistics_of(const Result& result) {
  StatisticsOptions options;
  options.bootstrap.resamples = 0;
  return compute_statistics(graph_from_network(result.state().network, result.state().mesh()),
                            options);
}

TEST(ACrackPattern, HasTheSameStatisticsOnTheAssetAsOnTheSimulationsMesh) {
  for (const Asset& asset : hard_edged()) {
    SCOPED_TRACE(asset.name);
    Recipe recipe = recipe_for("mud", 0.09);
    const Result on_asset = cracked(asset.mesh, recipe);
    recipe.mesh.output = OutputMesh::simulation;
    const Result on_mesh = cracked(asset.mesh, recipe);
    const CrackCounts &a = on_asset.report().cracks, &b = on_mesh.report().cracks;
    EXPECT_NEAR(a.length / b.length, 1, 0.02);
    EXPECT_EQ(a.events, b.events);
    const Statistics s = statistics_of(on_asset), t = statistics_of(on_mesh);
    EXPECT_NEAR(s.root_area.value / t.root_area.value, 1, 0.02);
    EXPECT_NEAR(s.t_fraction.value, t.t_fraction.value, 0.02);
  }
}

TEST(ACrackPattern, AddsTrianglesInProportionToItsLength) {
  const SurfaceMesh cube = make_shape("cube?n=1");
  std::vector<double> per_segment;
  for (const double spacing : {0.12, 0.08, 0.05}) {
    const Report report = cracked(cube, recipe_for("glaze", spacing)).report();
    per_segment.push_back(static_cast<double>(report.carried.added_triangles) /
                          static_cast<double>(report.cracks.segments));
    EXPECT_LT(report.output.triangles, report.simulation.triangles);
  }
  for (const double n : per_segment) EXPECT_NEAR(n / per_segment.front(), 1, 0.1);
}

TEST(ACrackPattern, IsCarriedOverAlikeOnAnyNumberOfThreads) {
  const SurfaceMesh mesh = bevelled_cube(0.15);
  Context one;
  one.threads = Threads(1);
  const SurfaceMesh a = cut_mesh(cracked(mesh, recipe_for("paint", 0.1), {}, one), one);
  const SurfaceMesh b = cut_mesh(cracked(mesh, recipe_for("paint", 0.1)), {});
  ASSERT_EQ(a.triangles, b.triangles);
  EXPECT_TRUE(test::same_bits(a.positions.data(), b.positions.data(), a.positions.size()));
}

TEST(ARoughScan, CracksAsTheSmoothShapeDoesAndIsNotSmoothedItself) {
  const SurfaceMesh smooth = make_shape("sphere?n=60");
  const double edge = mean_edge(smooth.positions, smooth.triangles);
  SurfaceMesh rough = smooth;
  Random random(3);
  for (Vec3& p : rough.positions) p *= 1 + 0.3 * edge * random.normal();
  const Recipe recipe = recipe_for("glaze", 0.15);
  const Result on_scan = cracked(rough, recipe);
  EXPECT_LT(on_scan.report().simulation.triangles, on_scan.report().input.triangles / 4);
  EXPECT_LT(on_scan.report().carried.lost_length, 1e-3 * on_scan.report().cracks.length);
  const SurfaceMesh cut = cut_mesh(on_scan, {});
  EXPECT_TRUE(validate(TriangleMesh(cut.positions, cut.triangles)).empty());
  EXPECT_TRUE(
      test::same_bits(cut.positions.data(), rough.positions.data(), rough.positions.size()));
  EXPECT_NEAR(area_of(cut) / area_of(rough), 1, 1e-9);
  const double fragments = static_cast<double>(on_scan.report().cracks.fragments);
  EXPECT_NEAR(fragments / static_cast<double>(cracked(smooth, recipe).report().cracks.fragments), 1,
              0.2);
}

TEST(AFoldedScan, LosesNoCrackAndGainsNoFreeEnd) {
  const SurfaceMesh smooth = make_shape("sphere?n=50");
  const double edge = mean_edge(smooth.positions, smooth.triangles);
  for (const double height : {0.3, 0.5}) {
    SCOPED_TRACE(height);
    SurfaceMesh folded = smooth;
    Random random(1);
    for (Vec3& p : folded.positions) {
      for (int i = 0; i < 3; ++i) p[i] += height * edge * random.normal();
    }
    const Result result = cracked(folded, recipe_for("glaze", 0.18));
    const Simulation& simulation = *result.state().simulation;
    EXPECT_EQ(result.report().carried.lost_pieces, 0);
    const double pieces = find_components(simulation.mesh()).count;
    EXPECT_NEAR(static_cast<double>(result.report().cracks.fragments) / pieces, 1, 0.02);
    StatisticsOptions options;
    options.bootstrap.resamples = 0;
    const Statistics grown = compute_statistics(
        graph_from_network(crack_network(simulation), simulation.mesh()), options);
    EXPECT_NEAR(statistics_of(result).dead_ends.value, grown.dead_ends.value, 0.02);
    const SurfaceMesh cut = cut_mesh(result, {});
    EXPECT_TRUE(validate(TriangleMesh(cut.positions, cut.triangles)).empty());
    EXPECT_NEAR(area_of(cut) / area_of(folded), 1, 1e-9);
  }
}

TEST(AnAssetThatFitsTheSpacing, CracksItself) {
  const SurfaceMesh mesh = make_shape("sphere?n=40");
  Recipe recipe = recipe_for("glaze", 0.2);
  recipe.mesh.edge.kind = EdgeLength::Kind::keep;
  const Result as_asset = cracked(mesh, recipe);
  EXPECT_EQ(as_asset.state().asset, nullptr);
  recipe.mesh.output = OutputMesh::simulation;
  const SurfaceMesh a = cut_mesh(as_asset, {}), b = cut_mesh(cracked(mesh, recipe), {});
  ASSERT_EQ(a.triangles, b.triangles);
  EXPECT_TRUE(test::same_bits(a.positions.data(), b.positions.data(), a.positions.size()));
}

TEST(ARunWithoutCracks, GivesTheAssetBack) {
  const SurfaceMesh mesh = test::dressed(make_shape("cube?n=2"));
  const Result result = cracked(mesh, recipe_for("glaze", 0.1), {.max_cracks = 0});
  const SurfaceMesh cut = cut_mesh(result, {});
  EXPECT_EQ(cut.triangles, mesh.triangles);
  EXPECT_TRUE(test::same_bits(cut.positions.data(), mesh.positions.data(), mesh.positions.size()));
  EXPECT_TRUE(
      test::same_bits(cut.corner_uvs.data(), mesh.corner_uvs.data(), mesh.corner_uvs.size()));
  EXPECT_GT(result.report().simulation.triangles, 100);
}

TEST(AnOpenedGap, StaysOnThePlanesOfAHardEdgedAsset) {
  for (const Asset& asset : {hard_edged()[0], hard_edged()[1]}) {
    SCOPED_TRACE(asset.name);
    const Result result = cracked(asset.mesh, recipe_for("glaze", 0.1));
    const SurfaceMesh opened = Opening(result, {0.02, 0, 0}, {}).mesh();
    const SurfaceMesh shut = cut_mesh(result, {});
    double furthest = 0;
    for (std::size_t f = 0; f < shut.triangles.size(); ++f) {
      const Triangle& t = asset.mesh.triangles[opened.source_faces[f]];
      const Vec3 normal = test::area_vector(asset.mesh.positions, t).normalized();
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& p = opened.positions[opened.triangles[f][i]];
        EXPECT_NEAR((p - asset.mesh.positions[t[0]]).dot(normal), 0, 1e-9);
        furthest = std::max(furthest, (p - shut.positions[shut.triangles[f][i]]).norm());
      }
    }
    EXPECT_GT(furthest, 1e-3);
  }
}

TEST(AnOpenedGap, IsNotHeldShutByShellsThatPassThroughEachOther) {
  SurfaceMesh mesh = make_shape("plate?n=4");
  mesh.corner_uvs.clear();
  const auto first = static_cast<std::int32_t>(mesh.positions.size());
  const std::size_t faces = mesh.triangles.size();
  for (std::int32_t v = 0; v < first; ++v) {
    const Vec3 p = mesh.positions[v];
    mesh.positions.emplace_back(p.x() + 0.013, 0.3 * p.y(), p.y() + 0.1);
  }
  for (std::size_t f = 0; f < faces; ++f) {
    const Triangle t = mesh.triangles[f];
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const Result result = cracked(mesh, recipe_for("glaze", 0.05));
  EXPECT_GT(result.report().cracks.fragments, 40);
  EXPECT_TRUE(Opening(result, {0.01, 0, 0}, {}).warnings().empty());
}

/// Where `origin` says that a corner lies, in the input.
Vec3 place_of(const SurfaceMesh& input, const SurfaceOrigin& origin, std::size_t corner) {
  const Triangle& t = input.triangles[origin.face[corner / 3]];
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < 3; ++i) p += origin.weights[corner][i] * input.positions[t[i]];
  return p;
}

/// Repair has to merge, drop and turn here.
SurfaceMesh untidy_cube() {
  SurfaceMesh mesh = test::unwelded(make_shape("cube?n=2"));
  std::swap(mesh.triangles[5][1], mesh.triangles[5][2]);
  std::rotate(mesh.triangles[9].begin(), mesh.triangles[9].begin() + 1, mesh.triangles[9].end());
  mesh.triangles.insert(mesh.triangles.begin() + 3, Triangle{0, 0, 1});
  return mesh;
}

TEST(TheOriginOfACutMesh, NamesTheInputsTriangleOfEachFaceAndTheRimAboveEachWall) {
  const SurfaceMesh mesh = untidy_cube();
  for (const char* edge : {"auto", "keep"}) {
    SCOPED_TRACE(edge);
    Recipe recipe = recipe_for("glaze", 0.15);
    if (edge == std::string("keep")) {
      recipe.mesh.edge.kind = EdgeLength::Kind::keep;
      recipe.simulation.crack.near_vertex = NearVertex::snap;  // no vertex moves
    }
    const Result result = cracked(mesh, recipe);
    const SurfaceMesh shut = cut_mesh(result, {});
    for (const PostParameters& post :
         {PostParameters{}, PostParameters{0.02, 0, 0}, PostParameters{0.02, 0.01, 0},
          PostParameters{0.02, 0.01, 1}}) {
      const Opening opening(result, post, {});
      const SurfaceOrigin origin = opening.origin();
      const SurfaceMesh& opened = opening.mesh();
      ASSERT_EQ(origin.face.size(), opened.triangles.size());
      ASSERT_EQ(origin.weights.size(), 3 * opened.triangles.size());
      double area = 0;
      for (std::size_t f = 0; f < opened.triangles.size(); ++f) {
        ASSERT_NE(origin.face[f], 3) << "without area, dropped";
        Vec3 p[3];
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_NEAR(origin.weights[3 * f + i].sum(), 1, 1e-12);
          EXPECT_GE(origin.weights[3 * f + i].minCoeff(), 0);
          p[i] = place_of(mesh, origin, 3 * f + i);
        }
        const bool wall = static_cast<std::int32_t>(f) >= origin.wall_begin;
        EXPECT_EQ(wall, opened.source_faces[f] < 0);
        if (wall) continue;
        area += (p[1] - p[0]).cross(p[2] - p[0]).norm() / 2;
        if (f >= shut.triangles.size() || post.curl != 0) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_LT((p[i] - shut.positions[shut.triangles[f][i]]).norm(), 1e-9);
        }
      }
      EXPECT_NEAR(area / area_of(make_shape("cube?n=2")), 1, 1e-9);
      if (post.wall == 0) {
        EXPECT_EQ(origin.wall_begin, std::ssize(opened.triangles));
      }
    }
  }
}

TEST(TheOriginOfACutMesh, IsUnknownOnTheSimulationsMesh) {
  Recipe recipe = recipe_for("glaze", 0.2);
  recipe.mesh.output = OutputMesh::simulation;
  EXPECT_TRUE(Opening(cracked(make_shape("cube?n=1"), recipe), {}, {}).origin().face.empty());
}

TEST(CurlOnAnAsset, SplitsWhatIsTooLargeToBend) {
  // On the cylinder some sides of cracks are longer than the triangles should be.
  for (const auto& [shape, preset] :
       {std::pair("cube?n=1", "mud"), std::pair("cylinder?n=8", "paint")}) {
    SCOPED_TRACE(shape);
    const Result result = cracked(make_shape(shape), recipe_for(preset, 0.1));
    const Opening flat(result, {0.02, 0, 0}, {}), curled(result, {0.02, 0, 1}, {});
    EXPECT_GT(curled.mesh().triangles.size(), flat.mesh().triangles.size());
    EXPECT_LT(curled.mesh().triangles.size(), 20 * flat.mesh().triangles.size());
    EXPECT_TRUE(validate(TriangleMesh(curled.mesh().positions, curled.mesh().triangles)).empty());
    // The vertices of the cut mesh come first, in its order, and all start on the surface.
    const SurfaceMesh shut = cut_mesh(result, {});
    const std::vector<Vec3> start = GrowthClip(curled).positions_at(0);
    ASSERT_GE(start.size(), shut.positions.size());
    for (std::size_t v = 0; v < shut.positions.size(); ++v) EXPECT_EQ(start[v], shut.positions[v]);
    const ClosestPoint surface(shut.positions, shut.triangles);
    for (const Vec3& p : start) EXPECT_LT(surface.find(p, {}).distance, 1e-9);
  }
}

TEST(AssetOutput, AWordDuringTheCarryingStopsARunToDiscardAndIsTooLateForOneToKeep) {
  const SurfaceMesh cube = bevelled_cube(0.1);
  const Recipe recipe = recipe_for("glaze", 0.1);
  bool carrying = false;
  Context context;
  context.progress = [&](const Progress& p) { carrying = carrying || p.phase == "carry"; };
  context.cancelled = [&] { return carrying; };
  EXPECT_THROW(cracked(cube, recipe, {{}, OnCancel::discard}, context), Cancelled);
  EXPECT_TRUE(carrying);
  carrying = false;
  const Result kept = cracked(cube, recipe, {{}, OnCancel::keep}, context);
  EXPECT_EQ(kept.report().stop_reason, cracked(cube, recipe).report().stop_reason);
}

}  // namespace
}  // namespace craze
