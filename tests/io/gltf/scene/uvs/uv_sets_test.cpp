// UV sets of a kept scene, and one more of them.
#include "craze/io/gltf/scene/uvs/uv_sets.h"

#include <gtest/gtest.h>

#include "io/gltf/scene/truck.h"

namespace craze {
namespace {

std::shared_ptr<const GltfDocument> document_of(const SceneFile& file) {
  const MeshFile read = read_mesh(file.bytes(), "a.glb");
  return std::dynamic_pointer_cast<const GltfDocument>(read.scene);
}

/// Each triangle by itself: no two share a corner.
FurtherUvs apart(const GltfDocument& document, std::set<std::int32_t> materials) {
  FurtherUvs uvs;
  uvs.materials = std::move(materials);
  uvs.number = uv_set_count(document);
  for (std::size_t f = 0; f < document.triangles().size(); ++f) {
    const auto low = static_cast<double>(f) / 64;
    uvs.corners.insert(uvs.corners.end(),
                       {Vec2(low, 0), Vec2(low + 1.0 / 128, 0), Vec2(low, 1.0 / 128)});
  }
  return uvs;
}

TEST(UvSets, AreThoseOfTheFile) {
  const auto document = document_of(truck());
  ASSERT_TRUE(document);
  EXPECT_EQ(uv_set_count(*document), 2u);
  const UvSet second = uv_set(*document, 1), third = uv_set(*document, 2);
  EXPECT_EQ(second.corners[1], Vec2(3, 1));  // v upwards
  EXPECT_EQ(second.has, std::vector<char>(document->triangles().size(), 1));
  EXPECT_EQ(third.has, std::vector<char>(document->triangles().size(), 0));
}

TEST(FurtherUvs, LieAtEveryCornerAndLeaveTheRestAsItWas) {
  const auto document = document_of(truck());
  ASSERT_TRUE(document);
  const FurtherUvs uvs = apart(*document, {0, 1});
  const auto made = with_further_uvs(*document, uvs);
  ASSERT_EQ(made->triangles().size(), document->triangles().size());
  const UvSet set = uv_set(*made, uvs.number);
  EXPECT_EQ(set.has, std::vector<char>(made->triangles().size(), 1));
  for (std::size_t c = 0; c < uvs.corners.size(); ++c) {
    EXPECT_LT((set.corners[c] - uvs.corners[c]).norm(), 1e-7);
  }
  for (std::size_t n = 0; n < uvs.number; ++n) {
    EXPECT_EQ(uv_set(*made, n).corners, uv_set(*document, n).corners);
  }
  for (std::size_t f = 0; f < made->triangles().size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(made->positions()[made->triangles()[f][i]],
                document->positions()[document->triangles()[f][i]]);
    }
  }
  // What it says of itself is what another reader finds.
  SceneFile file;
  file.json = made->root();
  file.bin = made->bin();
  const MeshFile again = read_mesh(file.bytes(), "a.glb");
  ASSERT_EQ(again.mesh.triangles.size(), made->triangles().size());
  for (std::size_t f = 0; f < made->triangles().size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(again.mesh.positions[again.mesh.triangles[f][i]],
                made->positions()[made->triangles()[f][i]]);
    }
  }
  EXPECT_EQ(file.names("nodes"), SceneFile(truck().bytes()).names("nodes"));
}

TEST(FurtherUvs, KeepTheOldVerticesAndEverySetBelow) {
  const SceneFile before = truck();
  const auto document = document_of(before);
  const auto made = with_further_uvs(*document, apart(*document, {0, 1}));
  SceneFile after;
  after.json = made->root();
  after.bin = made->bin();
  // The wheels' mesh is shown twice: one of the two has a copy.
  EXPECT_NE(after.json["nodes"][2]["mesh"], after.json["nodes"][3]["mesh"]);
  const Json& flag = after.primitive(after.json["nodes"][5]["mesh"], 0);
  const Json& old = before.primitive(before.json["nodes"][5]["mesh"], 0);
  for (const char* name : {"POSITION", "NORMAL", "TEXCOORD_0", "TEXCOORD_1", "COLOR_0", "_PART",
                           "JOINTS_0", "WEIGHTS_0"}) {
    ASSERT_TRUE(flag["attributes"].contains(name)) << name;
    const std::string was = before.elements(old["attributes"][name]);
    EXPECT_EQ(after.elements(flag["attributes"][name]).substr(0, was.size()), was) << name;
  }
  const std::string was = before.elements(old["targets"][0]["POSITION"]);
  EXPECT_EQ(after.elements(flag["targets"][0]["POSITION"]).substr(0, was.size()), was);
  EXPECT_EQ(flag["extras"], old["extras"]);
  // Tangents lie along the new u.
  const std::vector<float> tangents = after.floats(flag["attributes"]["TANGENT"]),
                           normals = after.floats(flag["attributes"]["NORMAL"]);
  for (std::size_t i = 0; i < tangents.size(); i += 4) {
    const Vec3 t(tangents[i], tangents[i + 1], tangents[i + 2]);
    const std::size_t n = i / 4 * 3;
    EXPECT_NEAR(t.norm(), 1, 1e-6);
    EXPECT_NEAR(t.dot(Vec3(normals[n], normals[n + 1], normals[n + 2])), 0, 1e-6);
    EXPECT_EQ(std::abs(tangents[i + 3]), 1);
  }
}

TEST(FurtherUvs, OfOneMaterialLeaveTheOthersAlone) {
  const SceneFile before = truck();
  const auto document = document_of(before);
  const auto made = with_further_uvs(*document, apart(*document, {1}));
  const Json& body = made->root()["meshes"][0]["primitives"];
  EXPECT_FALSE(body[0]["attributes"].contains("TEXCOORD_2"));
  EXPECT_TRUE(body[1]["attributes"].contains("TEXCOORD_2"));
}

TEST(FurtherUvs, OfPrimitivesThatHaveFewerSetsFillTheGap) {
  SceneFile file = truck();
  for (const char* name : {"TEXCOORD_0", "TEXCOORD_1"}) {
    file.json["meshes"][1]["primitives"][0]["attributes"].erase(name);
  }
  const auto document = document_of(file);
  const auto made = with_further_uvs(*document, apart(*document, {0, 1}));
  const std::size_t wheel = made->root()["nodes"][2]["mesh"];
  const Json& attributes = made->root()["meshes"][wheel]["primitives"][0]["attributes"];
  for (const char* name : {"TEXCOORD_0", "TEXCOORD_1", "TEXCOORD_2"}) {
    EXPECT_TRUE(attributes.contains(name)) << name;
  }
}

TEST(FurtherUvs, GiveWhatIsNotOfTheSurfaceTheMaterialAsItWas) {
  SceneFile file = truck();
  Json spare = square(file, 1), outline = square(file, 1);
  outline["mode"] = 1;
  file.json["meshes"].push_back({{"name", "spare"}, {"primitives", {spare}}});
  file.json["meshes"][0]["primitives"].push_back(outline);
  const auto document = document_of(file);
  const auto made = with_further_uvs(*document, apart(*document, {1}));
  const Json& root = made->root();
  const std::size_t copy = root["meshes"][3]["primitives"][0]["material"];
  EXPECT_EQ(copy, 2u);
  EXPECT_EQ(root["materials"][copy], root["materials"][1]);
  EXPECT_EQ(root["meshes"][0]["primitives"][2]["material"], copy);
  EXPECT_EQ(root["meshes"][0]["primitives"][1]["material"], 1);
}

}  // namespace
}  // namespace craze
