// Fragments as closed solids, of whole runs.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>

#include "craze/error.h"
#include "craze/mesh/self_intersection.h"
#include "products/solids/solid_checks.h"

namespace craze {
namespace {

constexpr OutputMesh outputs[] = {OutputMesh::asset, OutputMesh::simulation};

PostParameters solid(double thickness, double gap = 0, double curl = 0) {
  PostParameters post;
  post.thickness = thickness;
  post.gap = gap;
  post.curl = curl;
  return post;
}

/// The crossings of triangles of different solids.
std::size_t pairs_between(const SurfaceMesh& mesh) {
  const Attribute& fragment = *find_attribute(mesh.face_attributes, "fragment");
  std::size_t count = 0;
  for (const auto& [f, g] : self_intersections(mesh.positions, mesh.triangles)) {
    if (fragment.values[f] != fragment.values[g]) ++count;
  }
  return count;
}

/// Where cracks gape rims may be in each other's way; that is said.
bool says_it_crosses(const Opening& opening) {
  for (const std::string& warning : opening.warnings()) {
    if (warning.find("pieces still pass through") != std::string::npos) return true;
  }
  return false;
}

void expect_sound(const std::vector<SurfaceMesh>& solids) {
  ASSERT_FALSE(solids.empty());
  for (std::size_t i = 0; i < solids.size(); ++i) {
    EXPECT_TRUE(test::is_closed(solids[i])) << "solid " << i;
    EXPECT_GT(test::volume_of(solids[i]), 0) << "solid " << i;
  }
}

TEST(Solids, AreClosedHavePositiveVolumeAndDoNotMeet) {
  for (const char* preset : {"mud", "glaze", "paint", "concrete-crazing"}) {
    for (const char* shape : {"plate?n=20&jitter=0.3", "cup", "sphere?n=14", "torus", "cube"}) {
      SCOPED_TRACE(std::string(preset) + " on " + shape);
      const Result result = test::cracked_shape(shape, preset, 0.2);
      for (const double gap : {0.0, 0.05}) {
        SCOPED_TRACE(gap);
        const Opening opening(result, solid(0.04, gap), {});
        const std::vector<SurfaceMesh> solids = fragments(opening.mesh());
        EXPECT_EQ(static_cast<std::int64_t>(solids.size()), result.report().cracks.fragments);
        expect_sound(solids);
        if (gap == 0) {
          EXPECT_FALSE(says_it_crosses(opening));
        }
        if (says_it_crosses(opening)) continue;
        EXPECT_EQ(pairs_between(opening.mesh()), 0U);
        EXPECT_LE(test::most_often_inside(solids, 100), 1);
      }
    }
  }
}

TEST(Solids, OfTheSimulationsMeshAreJustAsSound) {
  for (const char* shape : {"plate?n=20&jitter=0.3", "cup", "sphere?n=14"}) {
    SCOPED_TRACE(shape);
    const Result result = test::cracked_shape(shape, "mud", 0.15, OutputMesh::simulation);
    for (const double gap : {0.0, 0.05}) {
      const Opening opening(result, solid(0.03, gap, 0.3), {});
      const std::vector<SurfaceMesh> solids = fragments(opening.mesh());
      expect_sound(solids);
      EXPECT_EQ(pairs_between(opening.mesh()), 0U);
      EXPECT_LE(test::most_often_inside(solids, 100), 1);
    }
  }
}

TEST(Solids, WithWedgesMeetAtTheirInnerSurfacesAndNowhereElse) {
  for (const char* shape : {"plate?n=20&jitter=0.3", "cup", "sphere?n=14"}) {
    SCOPED_TRACE(shape);
    const Result result = test::cracked_shape(shape, "mud", 0.2);
    PostParameters post = solid(0.04, 0.05);
    const SurfaceMesh straight = Opening(result, post, {}).mesh(),
                      shut = Opening(result, solid(0.04), {}).mesh();
    for (const double wedge : {0.5, 1.0}) {
      post.wedge = wedge;
      const Opening opening(result, post, {});
      const std::vector<SurfaceMesh> solids = fragments(opening.mesh());
      expect_sound(solids);
      EXPECT_FALSE(says_it_crosses(opening));
      EXPECT_EQ(pairs_between(opening.mesh()), 0U);
      EXPECT_LE(test::most_often_inside(solids, 100), 1);
      if (std::string(shape).rfind("plate", 0) != 0) continue;
      // The inner surface of a plate is opened by the rest of the gap alone.
      const std::vector<Vec3>& p = opening.mesh().positions;
      ASSERT_EQ(p.size(), straight.positions.size());
      ASSERT_EQ(p.size(), shut.positions.size());
      for (std::size_t v = 0; v < p.size(); ++v) {
        const double share = p[v].z() < -0.02 ? wedge : 0;
        const Vec3 wanted =
            straight.positions[v] + share * (shut.positions[v] - straight.positions[v]);
        EXPECT_LT((p[v] - wanted).norm(), 1e-9);
      }
    }
  }
}

double total_volume(const std::vector<SurfaceMesh>& solids) {
  double total = 0;
  for (const SurfaceMesh& s : solids) total += test::volume_of(s);
  return total;
}

TEST(Solids, OfAPlateAddUpToThicknessTimesArea) {
  for (const OutputMesh output : outputs) {
    const Result result = test::cracked_shape("plate?n=20&jitter=0.3", "mud", 0.2, output);
    const double area = test::area_of(cut_mesh(result, {}));
    const Opening opening(result, solid(0.1), {});
    EXPECT_TRUE(opening.warnings().empty());
    EXPECT_NEAR(total_volume(fragments(opening.mesh())), 0.1 * area, 1e-9 * area);
  }
}

TEST(Solids, OfABallAddUpToItsShell) {
  const Result result = test::cracked_shape("sphere?n=20", "mud", 0.25);
  const SurfaceMesh ball = cut_mesh(result, {});
  const double area = test::area_of(ball), volume = test::volume_of(ball),
               radius = 3 * volume / area;
  for (const double share : {0.02, 0.1, 0.3}) {
    const double d = share * radius;
    const Opening opening(result, solid(d), {});
    // Steiner: area · d less what is lost to curvature; the triangles' error is that of the mesh.
    const double shell = area * d * (1 - share + share * share / 3);
    EXPECT_NEAR(total_volume(fragments(opening.mesh())), shell, 0.01 * shell) << share;
  }
}

TEST(Solids, OfACubeHaveItsEdgesInside) {
  const Result result = test::cracked_shape("cube", "mud", 0.3);
  const SurfaceMesh cube = cut_mesh(result, {});
  const double side = std::cbrt(test::volume_of(cube));
  const double d = 0.05 * side;  // less than the first row of triangles is wide
  const Opening opening(result, solid(d), {});
  const double shell = side * side * side - std::pow(side - 2 * d, 3);
  EXPECT_NEAR(total_volume(fragments(opening.mesh())), shell, 0.01 * shell);
}

TEST(Solids, WithTheirCoreFillTheWholeOfAClosedShape) {
  for (const char* shape : {"sphere?n=14", "cube", "torus"}) {
    SCOPED_TRACE(shape);
    const Result result = test::cracked_shape(shape, "mud", 0.25);
    PostParameters post = solid(0.05);
    post.core = true;
    const Opening opening(result, post, {});
    const std::vector<SurfaceMesh> solids = fragments(opening.mesh());
    EXPECT_EQ(static_cast<std::int64_t>(solids.size()), result.report().cracks.fragments + 1);
    expect_sound(solids);
    const double whole = test::volume_of(cut_mesh(result, {}));
    EXPECT_NEAR(total_volume(solids), whole, 1e-9 * whole);
    EXPECT_EQ(pairs_between(opening.mesh()), 0U);
  }
}

TEST(Solids, StayClearOfTheirCoreWhereCracksGape) {
  const Result result = test::cracked_shape("sphere?n=14", "mud", 0.25);
  PostParameters post = solid(0.05, 0.05);
  post.core = true;
  const Opening opening(result, post, {});
  const std::vector<SurfaceMesh> solids = fragments(opening.mesh());
  expect_sound(solids);
  EXPECT_EQ(pairs_between(opening.mesh()), 0U);
  EXPECT_LE(test::most_often_inside(solids, 200), 1);
}

TEST(Solids, HaveNoCoreWhereTheSurfaceIsOpen) {
  const Result result = test::cracked_shape("plate?n=12", "mud", 0.3);
  PostParameters post = solid(0.05);
  post.core = true;
  const Opening opening(result, post, {});
  EXPECT_EQ(static_cast<std::int64_t>(fragments(opening.mesh()).size()),
            result.report().cracks.fragments);
  ASSERT_EQ(opening.warnings().size(), 1U);
  EXPECT_NE(opening.warnings()[0].find("post.core"), std::string::npos);
}

TEST(Solids, AreThinnerWhereThereIsNoRoom) {
  for (const char* shape : {"sphere?n=12", "cube", "torus", "cup"}) {
    for (const double thickness : {3.0, 1e6, 1e300}) {
      SCOPED_TRACE(shape);
      const Result result = test::cracked_shape(shape, "mud", 0.3);
      const Opening opening(result, solid(thickness), {});
      const std::vector<SurfaceMesh> solids = fragments(opening.mesh());
      expect_sound(solids);
      EXPECT_EQ(pairs_between(opening.mesh()), 0U);
      ASSERT_FALSE(opening.warnings().empty());
      EXPECT_NE(opening.warnings()[0].find("post.thickness"), std::string::npos);
    }
  }
}

TEST(Solids, OfAThinClosedSlabMeetInItsMiddle) {
  SurfaceMesh slab = make_shape("cube");
  for (Vec3& p : slab.positions) p.z() *= 0.02;
  const Result result = test::cracked_mesh(slab, "mud", 0.2);
  const Opening opening(result, solid(0.5), {});
  const std::vector<SurfaceMesh> solids = fragments(opening.mesh());
  expect_sound(solids);
  EXPECT_EQ(pairs_between(opening.mesh()), 0U);
  const double whole = test::volume_of(cut_mesh(result, {}));
  EXPECT_LT(total_volume(solids), whole);
  EXPECT_GT(total_volume(solids), 0.6 * whole);
}

TEST(Solids, MayBeVeryThin) {
  const Result result = test::cracked_shape("cup", "glaze", 0.2);
  const double area = test::area_of(cut_mesh(result, {}));
  const Opening opening(result, solid(1e-6), {});
  const std::vector<SurfaceMesh> solids = fragments(opening.mesh());
  expect_sound(solids);
  EXPECT_NEAR(total_volume(solids), 1e-6 * area, 1e-3 * 1e-6 * area);
}

TEST(Solids, OfOneTriangleAreAPrism) {
  SurfaceMesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  mesh.triangles = {{0, 1, 2}};
  Recipe recipe = read_preset("mud");
  recipe.mesh.edge = EdgeLength{EdgeLength::Kind::keep, {}};
  Input input;
  input.surface = std::make_shared<const SurfaceMesh>(mesh);
  CrackOptions none;
  none.max_cracks = 0;
  const Result result = crack(std::move(input), recipe, none, {});
  const std::vector<SurfaceMesh> solids = fragments(Opening(result, solid(0.2), {}).mesh());
  ASSERT_EQ(solids.size(), 1U);
  expect_sound(solids);
  EXPECT_NEAR(test::volume_of(solids[0]), 0.1, 1e-12);
}

TEST(Solids, OfASurfaceThatIsNoManifoldAreClosedAllTheSame) {
  // Three sheets along one edge.
  SurfaceMesh mesh = make_shape("plate?n=10");
  const auto count = static_cast<std::int32_t>(mesh.positions.size());
  const SurfaceMesh flat = mesh;
  for (const Vec3& p : flat.positions) mesh.positions.emplace_back(0, p.y(), p.x() + 0.5);
  for (const Triangle& t : flat.triangles) {
    mesh.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  mesh.corner_uvs.clear();
  mesh.corner_normals.clear();
  const Result result = test::cracked_mesh(mesh, "mud", 0.2);
  for (const SurfaceMesh& s : fragments(Opening(result, solid(0.02), {}).mesh())) {
    EXPECT_TRUE(test::is_closed(s));
  }
}

TEST(Solids, KeepWhatTheOuterSurfaceHas) {
  const Result result = test::cracked_shape("cup", "mud", 0.2);
  const SurfaceMesh cut = cut_mesh(result, {});
  const SurfaceMesh mesh = Opening(result, solid(0.02), {}).mesh();
  ASSERT_GT(mesh.triangles.size(), 2 * cut.triangles.size());
  for (std::size_t f = 0; f < cut.triangles.size(); ++f) {
    EXPECT_EQ(mesh.triangles[f], cut.triangles[f]);
    for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
      EXPECT_EQ(mesh.corner_uvs[c], cut.corner_uvs[c]);
      EXPECT_EQ(mesh.corner_normals[c], cut.corner_normals[c]);
    }
    EXPECT_EQ(mesh.face_materials[f], -1);
  }
  for (std::size_t f = cut.triangles.size(); f < mesh.triangles.size(); ++f) {
    EXPECT_EQ(mesh.material_names[mesh.face_materials[f]], "crack_wall");
    const Triangle& t = mesh.triangles[f];
    const auto top = static_cast<std::int32_t>(cut.positions.size());
    if (*std::min_element(t.begin(), t.end()) >= top)
      continue;  // an inner surface, which is smooth
    const Vec3 n = (mesh.positions[t[1]] - mesh.positions[t[0]])
                       .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
    for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
      EXPECT_GE(mesh.corner_normals[c].dot(n), 0.999 * n.norm());
    }
  }
}

TEST(Solids, OfNoThicknessAreTheSurfaceAsItWas) {
  const Result result = test::cracked_shape("cup", "mud", 0.2);
  PostParameters post;
  post.gap = 0.05;
  post.wall = 0.02;
  const SurfaceMesh before = Opening(result, post, {}).mesh();
  post.core = true;
  post.thickness = 0;
  const SurfaceMesh after = Opening(result, post, {}).mesh();
  EXPECT_EQ(before.positions, after.positions);
  EXPECT_EQ(before.triangles, after.triangles);
  post.thickness = -1;
  EXPECT_THROW(Opening(result, post, {}), Error);
  post.thickness = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Opening(result, post, {}), Error);
}

TEST(Solids, GrowWithWhatIsAboveThem) {
  const Result result = test::cracked_shape("plate?n=16", "mud", 0.25);
  const Opening opening(result, solid(0.03, 0.05), {});
  const GrowthClip clip(opening);
  EXPECT_EQ(clip.positions_at(1), opening.mesh().positions);
  SurfaceMesh shut = opening.mesh();
  shut.positions = clip.positions_at(0);
  for (const SurfaceMesh& s : fragments(shut)) EXPECT_GT(test::volume_of(s), 0);
}

TEST(Solids, OfRandomSmallMeshesAreSound) {
  const char* const shapes[] = {
      "plate?n=8&jitter=0.4", "cup?n=24", "sphere?n=6", "cube", "bowl", "strip", "torus"};
  const char* const presets[] = {"mud", "glaze", "paint", "crackle-glass", "mud-mature"};
  EXPECT_TRUE(rc::check([&] {
    const char* shape = shapes[*rc::gen::inRange<std::size_t>(0, std::size(shapes))];
    const char* preset = presets[*rc::gen::inRange<std::size_t>(0, std::size(presets))];
    const double thickness = std::pow(10, *rc::gen::inRange(-40, 10) / 10.0);
    const double gap = *rc::gen::element(0.0, 0.02, 0.2);
    const double curl = *rc::gen::element(0.0, 0.5, -0.5);
    const auto output = *rc::gen::element(OutputMesh::asset, OutputMesh::simulation);
    RC_LOG() << preset << " on " << shape << ", thickness " << thickness << ", gap " << gap
             << ", curl " << curl << ", output " << static_cast<int>(output);
    const Result result = test::cracked_shape(shape, preset, 0.35, output);
    const Opening opening(result, solid(thickness, gap, curl), {});
    for (const SurfaceMesh& s : fragments(opening.mesh())) {
      RC_ASSERT(test::is_closed(s));
      RC_ASSERT(test::volume_of(s) > 0);
    }
    RC_ASSERT(says_it_crosses(opening) || pairs_between(opening.mesh()) == 0U);
  }));
}

}  // namespace
}  // namespace craze
