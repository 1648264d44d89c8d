// Another surface than the input's, shown by the input's nodes.
#include <gtest/gtest.h>

#include <limits>

#include "io/gltf/scene/scene_file.h"

namespace craze {
namespace {

TEST(ResurfacedScene, HasUnitNormalsAndColoursWithinBounds) {
  SceneFile plain;
  plain.json["meshes"].push_back(
      {{"primitives",
        {{{"attributes", {{"POSITION", plain.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}}}}});
  plain.json["nodes"].push_back({{"mesh", 0}, {"scale", {2, 1, 1}}});
  plain.json["scenes"][0]["nodes"].push_back(0);
  const MeshFile file = read_mesh(plain.bytes(), "a.glb");

  SurfaceMesh other = file.mesh;
  other.positions.emplace_back(1, 0, 0);  // a face without area
  other.triangles.push_back({0, 1, 3});
  for (auto* numbers : {&other.face_objects, &other.face_materials}) {
    if (!numbers->empty()) numbers->push_back(numbers->front());
  }
  const float above = std::nextafter(1.0f, 2.0f);
  other.vertex_colors.assign(4, Color{above, -0.5f, 1, above});
  other.corner_normals.assign(6, Vec3::UnitZ());
  for (int c = 3; c < 6; ++c) other.corner_normals[c].setZero();

  const SceneFile after(format_mesh(other, "glb", {.scene = file.scene}));
  const Json& attributes = after.primitive(0, 0)["attributes"];
  const std::vector<float> normals = after.floats(attributes["NORMAL"]);
  ASSERT_FALSE(normals.empty());
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    EXPECT_NEAR(std::hypot(normals[i], normals[i + 1], normals[i + 2]), 1, 1e-6);
  }
  for (const float c : after.floats(attributes["COLOR_0"])) EXPECT_TRUE(c >= 0 && c <= 1) << c;
}

}  // namespace
}  // namespace craze
