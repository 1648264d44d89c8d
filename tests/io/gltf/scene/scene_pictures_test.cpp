// Materials of a kept scene that get pictures of their own.
#include "craze/io/gltf/scene/scene_pictures.h"

#include <gtest/gtest.h>

#include "craze/io/image/deflate.h"
#include "craze/io/image/encode_png.h"
#include "io/gltf/scene/scene_file.h"

namespace craze {
namespace {

#ifdef CRAZE_PNG

Image plain(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  return {1, 1, 3, std::vector<std::uint8_t>{r, g, b}};
}

/// Three triangles: with a picture that two materials share, with one alone, and with no material.
SceneFile shelf() {
  SceneFile file;
  Json& json = file.json;
  for (const Image& image : {plain(200, 0, 0), plain(0, 100, 0)}) {
    json["images"].push_back(
        {{"mimeType", "image/png"}, {"bufferView", file.add_view(encode_png(image))}});
  }
  json["textures"] = Json::parse(R"([{"source": 0}, {"source": 1}])");
  json["materials"] = Json::parse(R"([
    {"name": "red", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}},
    {"name": "also_red", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}},
    {"name": "green", "normalTexture": {"index": 1, "scale": 2, "texCoord": 1},
     "pbrMetallicRoughness": {"baseColorTexture": {"index": 1, "extensions":
       {"KHR_texture_transform": {"scale": [3, 1]}}}, "baseColorFactor": [0.5, 1, 1, 1],
       "roughnessFactor": 0.3}}])");
  json["extensionsUsed"] = {"KHR_texture_transform"};
  for (int i = 0; i < 4; ++i) {
    Json primitive;
    primitive["attributes"]["POSITION"] = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    primitive["attributes"]["TEXCOORD_0"] = file.add<float>({0, 0, 1, 0, 0, 1}, "VEC2", 5126, 2);
    if (i < 3) primitive["material"] = i;
    json["meshes"].push_back({{"primitives", {primitive}}});
    json["nodes"].push_back({{"mesh", i}, {"translation", {2.0 * i, 0, 0}}});
    json["scenes"][0]["nodes"].push_back(i);
  }
  return file;
}

std::shared_ptr<const GltfDocument> document_of(const SceneFile& file) {
  const MeshFile read = read_mesh(file.bytes(), "a.glb");
  return std::dynamic_pointer_cast<const GltfDocument>(read.scene);
}

NewPictures blue(std::int32_t material) {
  NewPictures made;
  made.material = material;
  made.pictures.base_color.image = plain(0, 0, 250);
  made.pictures.normal.image = plain(128, 128, 255);
  made.pictures.roughness.image = plain(250, 240, 10);
  return made;
}

Color color_shown(const GltfDocument& document, std::int32_t material) {
  const MaterialPictures own = material_pictures(document, material, [](const std::string&) {});
  const Image& image = own.pictures.base_color.image;
  if (image.empty()) return {1, 1, 1, 1};
  return {static_cast<float>(image.value(0, 0, 0)), static_cast<float>(image.value(0, 0, 1)),
          static_cast<float>(image.value(0, 0, 2)), 1};
}

TEST(ScenePictures, AreReadWithTheirFactorsAndPlaces) {
  const auto document = document_of(shelf());
  std::vector<std::string> warnings;
  const MaterialPictures green =
      material_pictures(*document, 2, [&](const std::string& w) { warnings.push_back(w); });
  EXPECT_EQ(green.pictures.base_color.image.value(0, 0, 1), 100 / 255.0);
  EXPECT_EQ(green.pictures.base_color.place(0, 0), 3);
  EXPECT_EQ(green.base_factor[0], 0.5f);
  EXPECT_EQ(green.pictures.roughness_factor, 0.3);
  EXPECT_EQ(green.pictures.base_color.uv_set, 0u);
  EXPECT_EQ(green.pictures.normal.uv_set, 1u);
  EXPECT_FALSE(green.kept[1]);
  EXPECT_TRUE(warnings.empty());
}

TEST(ScenePictures, TakeThePlaceOfTheirOwnMaterialsAlone) {
  const SceneFile file = shelf();
  const SceneFile made(format_with_pictures(*document_of(file), {blue(0)}, {}));
  const auto document = document_of(made);
  EXPECT_EQ(color_shown(*document, 0)[2], 250 / 255.0f);
  EXPECT_EQ(color_shown(*document, 1)[0], 200 / 255.0f);
  EXPECT_EQ(color_shown(*document, 2)[1], 100 / 255.0f);
  const Json& material = made.json["materials"][0];
  EXPECT_EQ(material["occlusionTexture"]["index"],
            material["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"]);
  EXPECT_EQ(material["pbrMetallicRoughness"]["roughnessFactor"], 1.0);
}

TEST(ScenePictures, OfAnotherUvSetSaySoAndTakeTheTangentsOfTheOldOneAway) {
  SceneFile file = shelf();
  for (const int mesh : {0, 1}) {
    Json& attributes = file.json["meshes"][mesh]["primitives"][0]["attributes"];
    attributes["TANGENT"] = file.add<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", 5126, 4);
    attributes["TEXCOORD_1"] = file.add<float>({0, 0, 1, 0, 0, 1}, "VEC2", 5126, 2);
  }
  NewPictures second = blue(0);
  second.uv_set = 1;
  const SceneFile made(format_with_pictures(*document_of(file), {second, blue(1)}, {}));
  const Json &moved = made.json["materials"][0], &stayed = made.json["materials"][1];
  EXPECT_EQ(moved["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"], 1);
  EXPECT_EQ(moved["normalTexture"]["texCoord"], 1);
  EXPECT_FALSE(stayed["normalTexture"].contains("texCoord"));
  EXPECT_FALSE(made.primitive(0, 0)["attributes"].contains("TANGENT"));
  EXPECT_TRUE(made.primitive(1, 0)["attributes"].contains("TANGENT"));
  second.has_tangents = true;
  const SceneFile renewed(format_with_pictures(*document_of(file), {second}, {}));
  EXPECT_TRUE(renewed.primitive(0, 0)["attributes"].contains("TANGENT"));
}

TEST(ScenePictures, ThatAreBrokenAreNamedAndHandedOn) {
  const auto warnings_of = [](const std::string& bytes, const char* type) {
    SceneFile file = shelf();
    file.json["images"].push_back(
        {{"name", "rust"}, {"mimeType", type}, {"bufferView", file.add_view(bytes)}});
    const MeshFile read = read_mesh(file.bytes(), "a.glb");
    EXPECT_NE(read.scene, nullptr);
    return read.warnings;
  };
  const std::string whole = encode_png(plain(1, 2, 3));
  std::string damaged = whole;
  damaged[45] ^= 1;
  EXPECT_TRUE(warnings_of(whole, "image/png").empty());
  EXPECT_TRUE(warnings_of("DDS any bytes", "image/vnd-ms.dds").empty());
  for (const auto& [bytes, why] :
       {std::pair<std::string, std::string>{whole.substr(0, whole.size() - 3), "it is cut off"},
        {whole.substr(0, 30), "it is cut off"},
        {damaged, "its bytes are damaged"},
        {"no picture", "it is no picture that is known"},
        {std::string("\xFF\xD8\xFF\xE0\0\x04\0\0", 8), "it is cut off"}}) {
    const std::vector<std::string> warnings = warnings_of(bytes, "image/png");
    ASSERT_EQ(warnings.size(), 1u) << why;
    EXPECT_EQ(warnings[0], "image 2 'rust' is broken, and is handed on as it is: " + why);
  }
}

TEST(ScenePictures, LeaveEveryPrimitiveAsItWas) {
  const SceneFile file = shelf();
  const SceneFile made(format_with_pictures(*document_of(file), {blue(0), blue(2)}, {}));
  for (std::size_t m = 0; m < 4; ++m) {
    EXPECT_EQ(made.primitive(m, 0), file.primitive(m, 0));
    for (const auto& [name, accessor] : file.primitive(m, 0)["attributes"].items()) {
      EXPECT_EQ(made.elements(accessor), file.elements(accessor));
    }
  }
}

TEST(ScenePictures, GiveTheirPlaceToNewOnesWhereNothingElseShowsThem) {
  SceneFile file = shelf();
  file.json["materials"][2].erase("normalTexture");
  const SceneFile alone(format_with_pictures(*document_of(file), {blue(2)}, {}));
  EXPECT_EQ(alone.json["images"].size(), 2u + 2u);
  const SceneFile shared(format_with_pictures(*document_of(file), {blue(0)}, {}));
  EXPECT_EQ(shared.json["images"].size(), 2u + 3u);
}

TEST(ScenePictures, KeepWhatIsToBeKept) {
  NewPictures made = blue(2);
  made.kept[1] = true;
  const SceneFile written(format_with_pictures(*document_of(shelf()), {made}, {}));
  EXPECT_EQ(written.json["materials"][2]["normalTexture"],
            shelf().json["materials"][2]["normalTexture"]);
  EXPECT_EQ(written.json["materials"][2]["pbrMetallicRoughness"]["baseColorTexture"].size(), 1u);
}

TEST(ScenePictures, MakeAMaterialForWhatHadNone) {
  const SceneFile made(format_with_pictures(*document_of(shelf()), {blue(-1)}, {}));
  ASSERT_TRUE(made.primitive(3, 0).contains("material"));
  EXPECT_EQ(made.primitive(3, 0)["material"], 3);
  EXPECT_EQ(made.primitive(0, 0)["material"], 0);
  EXPECT_EQ(color_shown(*document_of(made), 3)[2], 250 / 255.0f);
}

#endif

}  // namespace
}  // namespace craze
