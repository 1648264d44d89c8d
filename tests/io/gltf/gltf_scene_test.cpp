// What places a mesh in a glTF scene besides its node, and what files may require.
#include <nlohmann/json.hpp>

#include "craze/io/bytes/byte_order.h"
#include "craze/io/gltf/gltf.h"
#include "craze/io/source_scene.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

using Json = nlohmann::json;

/// A document under construction, whose accessors lie in one buffer.
class Document {
 public:
  Json json = Json::parse(R"({"asset": {"version": "2.0"}, "accessors": [], "bufferViews": [],
    "meshes": [{"primitives": [{"attributes": {}}]}], "nodes": [{"mesh": 0}]})");

  Json& primitive() { return json["meshes"][0]["primitives"][0]; }
  Json& node() { return json["nodes"][0]; }

  template <class T>
  std::size_t add_view(const std::vector<T>& numbers) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    const std::size_t offset = bytes_.size();
    for (const T x : numbers) append(bytes_, x);
    Json view;
    view["buffer"] = 0;
    view["byteOffset"] = offset;
    view["byteLength"] = bytes_.size() - offset;
    json["bufferViews"].push_back(view);
    return json["bufferViews"].size() - 1;
  }

  template <class T>
  std::size_t add(const std::vector<T>& numbers, const char* type, int component_type,
                  std::size_t components, bool normalized = false) {
    Json accessor;
    accessor["bufferView"] = add_view(numbers);
    accessor["componentType"] = component_type;
    accessor["count"] = numbers.size() / components;
    accessor["type"] = type;
    if (normalized) accessor["normalized"] = true;
    json["accessors"].push_back(accessor);
    return json["accessors"].size() - 1;
  }
  std::size_t add_vectors(const std::vector<float>& numbers) {
    return add(numbers, "VEC3", 5126, 3);
  }

  MeshFile read() {
    json["buffers"] = Json::array();
    json["buffers"].push_back(Json::object());
    json["buffers"][0]["uri"] = "all.bin";
    json["buffers"][0]["byteLength"] = bytes_.size();
    return read_mesh(json.dump(), "a.gltf", load_from_memory({{"all.bin", bytes_}}));
  }
  std::string message() {
    return message_of([&] { read(); });
  }

 private:
  std::string bytes_;
};

const std::vector<float> corner = {0, 0, 0, 1, 0, 0, 0, 1, 0};

Document triangle() {
  Document document;
  document.primitive()["attributes"]["POSITION"] = document.add_vectors(corner);
  return document;
}

bool says(const MeshFile& file, const std::string& text) {
  for (const std::string& w : file.warnings) {
    if (w.find(text) != std::string::npos) return true;
  }
  return false;
}

TEST(GltfSparse, ElementsReplaceThoseOfTheViewOrZeros) {
  for (const bool with_view : {true, false}) {
    Document document = triangle();
    Json& accessor = document.json["accessors"][0];
    if (!with_view) accessor.erase("bufferView");
    Json sparse;
    sparse["count"] = 2;
    sparse["indices"]["bufferView"] = document.add_view<std::uint16_t>({1, 2});
    sparse["indices"]["componentType"] = 5123;
    sparse["values"]["bufferView"] = document.add_view<float>({5, 6, 7, 8, 9, 10});
    document.json["accessors"][0]["sparse"] = sparse;
    const SurfaceMesh mesh = document.read().mesh;
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {5, 6, 7}, {8, 9, 10}}));
    document.json["accessors"][0]["sparse"]["count"] = 3;
    EXPECT_NE(document.message().find("beyond"), std::string::npos);
  }
}

TEST(GltfSparse, IndicesOutOfRangeAreRefused) {
  Document document = triangle();
  Json sparse;
  sparse["count"] = 1;
  sparse["indices"]["bufferView"] = document.add_view<std::uint8_t>({3});
  sparse["indices"]["componentType"] = 5121;
  sparse["values"]["bufferView"] = document.add_view<float>({5, 6, 7});
  document.json["accessors"][0]["sparse"] = sparse;
  EXPECT_NE(document.message().find("element 3 of 3"), std::string::npos);
}

TEST(GltfAccessor, WithoutAViewIsZeros) {
  Document document = triangle();
  document.json["accessors"].push_back(
      Json::parse(R"({"componentType": 5126, "count": 3, "type": "VEC2"})"));
  document.primitive()["attributes"]["TEXCOORD_0"] = 1;
  const SurfaceMesh mesh = document.read().mesh;
  ASSERT_EQ(mesh.corner_uvs.size(), 3u);
  for (const Vec2& uv : mesh.corner_uvs) EXPECT_EQ(uv, Vec2(0, 1)) << "v counts upwards here";
}

/// The triangle with two joints: one lifts by 7 and moves by −100 before, the other stays put.
Document skinned(const std::vector<float>& weights) {
  Document document = triangle();
  std::vector<float> bind(32, 0);
  for (const std::size_t j : {0u, 16u}) {
    for (const std::size_t k : {0u, 5u, 10u, 15u}) bind[j + k] = 1;
  }
  bind[12] = -100;
  Json& attributes = document.primitive()["attributes"];
  attributes["JOINTS_0"] =
      document.add<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4", 5121, 4);
  attributes["WEIGHTS_0"] = document.add(weights, "VEC4", 5126, 4);
  document.json["nodes"] = Json::parse(R"([{"mesh": 0, "skin": 0, "translation": [1000, 0, 0]},
    {"translation": [100, 0, 0], "children": [2]}, {"translation": [0, 0, 7]}, {}])");
  Json skin;
  skin["joints"] = {2, 3};
  skin["inverseBindMatrices"] = document.add(bind, "MAT4", 5126, 16);
  document.json["skins"].push_back(skin);
  return document;
}

TEST(GltfSkin, JointsPlaceTheMeshAndItsNodeDoesNot) {
  const SurfaceMesh mesh = skinned({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}).read().mesh;
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 7}, {1, 0, 7}, {0, 1, 7}}));
}

TEST(GltfSkin, WeightsMixJointsWhateverTheirSum) {
  const SurfaceMesh mesh = skinned({1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0}).read().mesh;
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 7}, {1, 0, 0}, {0, 1, 3.5}}));
}

TEST(GltfSkin, FurtherSetsAndNormalizedWeightsCount) {
  Document document = skinned({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  Json& attributes = document.primitive()["attributes"];
  attributes["JOINTS_1"] =
      document.add<std::uint16_t>(std::vector<std::uint16_t>(12, 0), "VEC4", 5123, 4);
  attributes["WEIGHTS_1"] =
      document.add<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}, "VEC4", 5121, 4, true);
  EXPECT_EQ(document.read().mesh.positions, (std::vector<Vec3>{{0, 0, 7}, {1, 0, 7}, {0, 1, 7}}));
}

TEST(GltfSkin, UnknownJointsAreRefused) {
  Document document = skinned({1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0});
  document.json["skins"][0]["joints"] = {2};
  EXPECT_NE(document.message().find("joint 1 of 1"), std::string::npos);
}

TEST(GltfSkin, MirroringJointsStillFaceOutwards) {
  Document document = skinned({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  document.json["nodes"][2]["scale"] = {-1, 1, 1};
  const SurfaceMesh mesh = document.read().mesh;
  const Triangle t = mesh.triangles[0];
  const Vec3 p = mesh.positions[t[0]];
  EXPECT_GT((mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p).z(), 0);
}

/// The triangle with two targets: one lifts all, one moves the first vertex.
Document morphed() {
  Document document = triangle();
  Json lift, move;
  lift["POSITION"] = document.add_vectors({0, 0, 1, 0, 0, 1, 0, 0, 1});
  move["POSITION"] = document.add_vectors({4, 0, 0, 0, 0, 0, 0, 0, 0});
  document.primitive()["targets"] = {lift, move};
  return document;
}

TEST(GltfMorph, TheMeshsWeightsHoldUnlessTheNodeHasItsOwn) {
  Document document = morphed();
  EXPECT_EQ(document.read().mesh.positions[0], Vec3(0, 0, 0));
  document.json["meshes"][0]["weights"] = {0.5, 0};
  EXPECT_EQ(document.read().mesh.positions[0], Vec3(0, 0, 0.5));
  document.node()["weights"] = {0.25, 0.5};
  EXPECT_EQ(document.read().mesh.positions[0], Vec3(2, 0, 0.25));
  EXPECT_EQ(document.read().mesh.positions[1], Vec3(1, 0, 0.25));
}

TEST(GltfMorph, NormalsMoveToo) {
  Document document = morphed();
  document.primitive()["attributes"]["NORMAL"] = document.add_vectors({0, 0, 1, 0, 0, 1, 0, 0, 1});
  document.primitive()["targets"][0]["NORMAL"] =
      document.add_vectors({1, 0, -1, 1, 0, -1, 1, 0, -1});
  document.json["meshes"][0]["weights"] = {1, 0};
  EXPECT_EQ(document.read().mesh.corner_normals[0], Vec3(1, 0, 0));
}

TEST(GltfInstancing, EachInstanceIsPlacedBelowItsNode) {
  Document document = triangle();
  Json& attributes = document.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes["TRANSLATION"] = document.add_vectors({0, 0, 1, 0, 0, 2});
  attributes["SCALE"] = document.add_vectors({1, 1, 1, 3, 3, 3});
  document.node()["translation"] = {10, 0, 0};
  document.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  const SurfaceMesh mesh = document.read().mesh;
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.positions[1], Vec3(11, 0, 1));
  EXPECT_EQ(mesh.positions[4], Vec3(13, 0, 2));
}

TEST(GltfObjects, FacesBelongToTheNodeThatShowsThem) {
  Document document = triangle();
  document.json["nodes"] = Json::parse(
      R"([{"name": "truck", "children": [1, 2]}, {"name": "wheel", "mesh": 0}, {"mesh": 0}])");
  const SurfaceMesh mesh = document.read().mesh;
  EXPECT_EQ(mesh.object_names, (std::vector<std::string>{"wheel", "node_2"}));
  EXPECT_EQ(mesh.face_objects, (std::vector<std::int32_t>{0, 1}));
}

TEST(GltfQuantization, SmallIntegersAreCoordinates) {
  Document document;
  document.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  document.node()["scale"] = {2, 2, 2};
  document.primitive()["attributes"]["POSITION"] =
      document.add<std::int16_t>({0, 0, 0, 32767, 0, 0, 0, -32767, 0}, "VEC3", 5122, 3, true);
  EXPECT_EQ(document.read().mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {0, -2, 0}}));
}

TEST(GltfExtensions, OnlyRequiredOnesThatAreNotKnownAreRefusedByName) {
  Document document = triangle();
  document.json["extensionsUsed"] = {"ACME_shape"};
  EXPECT_EQ(document.read().mesh.triangles.size(), 1u);
  for (const char* known : {"KHR_materials_unlit", "KHR_texture_transform"}) {
    document.json["extensionsRequired"] = {known};
    EXPECT_EQ(document.read().mesh.triangles.size(), 1u) << known;
  }
  for (const char* unknown :
       {"ACME_shape", "KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    document.json["extensionsRequired"] = {unknown};
    const std::string message = document.message();
    const bool named = message.find("'ACME_shape'") != std::string::npos ||
                       message.find("Draco") != std::string::npos ||
                       message.find("meshopt") != std::string::npos;
    EXPECT_TRUE(named) << message;
  }
}

TEST(GltfContents, WhatIsThereBesidesTheSurfaceIsListed) {
  Document document = triangle();
  document.primitive()["attributes"]["TANGENT"] =
      document.add<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 5126, 4);
  Json points = document.primitive();
  points["mode"] = 0;
  document.json["meshes"][0]["primitives"].push_back(points);
  document.json["cameras"] = Json::parse(R"([{"name": "eye"}])");
  document.json["images"] = Json::parse(R"([{"uri": "clay.png"}])");
  const MeshFile file = document.read();
  std::map<std::string, std::vector<std::string>> contents;
  ASSERT_NE(file.scene, nullptr);
  for (const SceneContent& content : file.scene->contents()) {
    contents[content.kind] = content.names;
  }
  EXPECT_EQ(contents["primitives of points or lines"].size(), 1u);
  EXPECT_EQ(contents["vertex attributes of its own"], (std::vector<std::string>{"TANGENT"}));
  EXPECT_EQ(contents["cameras"], (std::vector<std::string>{"eye"}));
  EXPECT_TRUE(says(file, "clay.png")) << "a picture that cannot be brought";
  EXPECT_EQ(file.textures, (std::vector<std::string>{"clay.png"}));
  EXPECT_TRUE(triangle().read().warnings.empty());
}

TEST(GltfContents, BandsThatDrawCracksAreNoSurfaceAndAreCountedAsSuch) {
  Document document = triangle();
  Json bands = document.primitive();
  bands["extras"] = {{"crack_lines", true}};
  document.json["meshes"].push_back(
      {{"name", "crack_lines"}, {"primitives", Json::array({std::move(bands)})}});
  document.json["nodes"].push_back({{"mesh", 1}});
  const MeshFile file = document.read();
  EXPECT_EQ(file.mesh.triangles.size(), 1u);
  std::map<std::string, std::vector<std::string>> contents;
  for (const SceneContent& content : file.scene->contents()) {
    contents[content.kind] = content.names;
  }
  EXPECT_EQ(contents["crack lines as bands of triangles"],
            (std::vector<std::string>{"crack_lines"}));
  EXPECT_FALSE(contents.contains("primitives of points or lines"));
  document.json["meshes"][1]["primitives"][0]["extras"]["crack_lines"] = false;
  EXPECT_EQ(document.read().mesh.triangles.size(), 2u) << "somebody else's mark";
}

TEST(Glb, PaddingOfEitherKindAndBytesAfterTheEndAreNoHarm) {
  const std::string plain = format_mesh(rich_mesh(), "glb");
  EXPECT_EQ(read_mesh(plain + "after the end", "a.glb").mesh.triangles.size(), 8u);
  std::string zeros = plain;
  const std::size_t json_end = 20 + load<std::uint32_t>(plain.data() + 12);
  std::size_t at = json_end;
  while (at > 0 && zeros[at - 1] == ' ') zeros[--at] = '\0';
  ASSERT_LE(json_end - at, 3u);
  EXPECT_EQ(read_mesh(zeros, "a.glb").mesh.triangles.size(), 8u);
}

TEST(Glb, FarFromTheOriginKeepsItsShape) {
  SurfaceMesh mesh = rich_mesh();
  const SurfaceMesh near = mesh;
  const Vec3 far(431250.3, 5412375.7, 120);
  for (Vec3& p : mesh.positions) p += far;
  for (const char* objects : {"", "fragment"}) {
    const std::string bytes = format_mesh(mesh, "glb", {.objects = objects});
    const SurfaceMesh back = read_mesh(bytes, "a.glb").mesh;
    double worst = 0;
    for (const Vec3& p : back.positions) {
      double nearest = 1;
      for (const Vec3& q : near.positions) nearest = std::min(nearest, (p - far - q).norm());
      worst = std::max(worst, nearest);
    }
    EXPECT_LT(worst, 1e-6) << "where single precision alone would move it by 0.25";
  }
}

}  // namespace
}  // namespace craze
