// What is attached to a surface is kept by a file or named.
#include "craze/output/lost_data.h"

#include <gtest/gtest.h>

#include "craze/io/source_scene.h"

namespace craze {
namespace {

class Scene : public SourceScene {
 public:
  std::vector<SceneContent> contents() const override {
    return {{"materials", {"clay"}}, {"vertex attributes of its own", {"wear"}}};
  }
};

SurfaceMesh full() {
  SurfaceMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.corner_uvs.assign(3, Vec2::Zero());
  mesh.corner_normals.assign(3, Vec3::UnitZ());
  mesh.vertex_colors.assign(3, Color{1, 1, 1, 1});
  mesh.face_materials = {0};
  mesh.material_names = {"clay"};
  mesh.vertex_attributes = {{"wear", 1, {0, 0, 0}}, {"crack_time", 1, {0, 0, 0}}};
  mesh.face_attributes = {
      {"red", 1, {0}}, {"green", 1, {0}}, {"blue", 1, {0}}, {"zone", 1, {7}}, {"fragment", 1, {0}}};
  return mesh;
}

TEST(LostData, IsNamedForEachFormatThatHasNoPlaceForIt) {
  const std::string all = "not kept of the surface, since ";
  EXPECT_EQ(describe_lost_data(full(), "stl", nullptr),
            all +
                ".stl has no place for them: texture coordinates, normals of vertices, colours "
                "of vertices, materials, vertex attribute 'wear', face attribute 'zone'");
  EXPECT_EQ(describe_lost_data(full(), "obj", nullptr),
            all +
                ".obj has no place for them: vertex attribute 'wear', face attribute 'red', face "
                "attribute 'green', face attribute 'blue', face attribute 'zone'");
  EXPECT_EQ(describe_lost_data(full(), "glb", nullptr),
            all +
                ".glb has no place for them: face attribute 'red', face attribute 'green', face "
                "attribute 'blue', face attribute 'zone'");
  for (const char* format : {"ply", "usda"}) {
    EXPECT_EQ(describe_lost_data(full(), format, nullptr), "") << format;
  }
}

TEST(LostData, OfASceneThatIsToldOfElsewhereIsNotNamedTwice) {
  const Scene scene;
  const std::string lost = describe_lost_data(full(), "stl", &scene);
  EXPECT_EQ(lost.find("materials"), std::string::npos) << lost;
  EXPECT_EQ(lost.find("wear"), std::string::npos) << lost;
  EXPECT_NE(lost.find("zone"), std::string::npos) << lost;
}

TEST(LostData, IsNamedBesideWhatTheSceneTellsOf) {
  const Scene scene;
  SurfaceMesh mesh = full();
  mesh.vertex_attributes.push_back({"heat", 1, {0, 0, 0}});
  for (const char* format : {"stl", "obj"}) {
    const std::string lost = describe_lost_data(mesh, format, &scene);
    EXPECT_NE(lost.find("vertex attribute 'heat'"), std::string::npos) << lost;
  }
}

TEST(RoundedData, AreWholeNumbersBeyondSinglePrecision) {
  SurfaceMesh mesh = full();
  mesh.vertex_attributes = {{"id", 1, {1, 2, 16777217}},
                            {"small", 1, {1, 2, 16777216}},
                            {"heat", 1, {0.1, 0.2, 1e-9}},
                            {"crack_time", 1, {0, 0, 16777217}}};
  EXPECT_EQ(describe_rounded_data(mesh, "glb"),
            "whole numbers of vertex attributes are rounded, since .glb holds single precision: "
            "'id'");
  for (const char* format : {"ply", "usda", "obj", "stl"}) {
    EXPECT_EQ(describe_rounded_data(mesh, format), "") << format;
  }
}

TEST(Unit, IsTheMetreInGlbAlone) {
  EXPECT_EQ(
      describe_unit(0.001, "glb"),
      "glTF is in metres (mesh.unit): one unit of the mesh, 0.001 m, is 1 m in the .glb; scale "
      "it by 0.001 where it is used");
  EXPECT_EQ(describe_unit(1, "glb"), "");
  EXPECT_EQ(describe_unit(0, "glb"), "") << "not known";
  for (const char* format : {"ply", "obj", "stl", "usda"})
    EXPECT_EQ(describe_unit(0.001, format), "");
}

TEST(LostData, OfASurfaceWithoutAnyIsNone) {
  SurfaceMesh bare;
  bare.positions = full().positions;
  bare.triangles = full().triangles;
  for (const char* format : {"stl", "obj", "glb", "ply", "usda"}) {
    EXPECT_EQ(describe_lost_data(bare, format, nullptr), "") << format;
  }
}

TEST(ReplacedData, AreTheOwnAttributesThatHaveTheNamesOfARuns) {
  EXPECT_EQ(describe_replaced_data(full()),
            "attributes that the surface had are replaced by those of this run: 'crack_time', "
            "'fragment'");
  SurfaceMesh bare = full();
  bare.vertex_attributes.clear();
  bare.face_attributes.clear();
  EXPECT_EQ(describe_replaced_data(bare), "");
}

}  // namespace
}  // namespace craze
