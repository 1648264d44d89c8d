// What a glTF or PLY file says of the colours of its materials.
#include <nlohmann/json.hpp>

#include "craze/io/bytes/byte_order.h"
#include "io/io_test_tools.h"

namespace craze {
namespace {

using Json = nlohmann::json;

std::string base64(const std::string& bytes) {
  static const char* const letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t block = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      block = block << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : letters[block >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

/// One triangle; its buffer ends with the bytes of a picture, view 1.
Json document(const std::string& picture = "a picture") {
  std::string bytes;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append(bytes, x);
  const std::size_t size = bytes.size();
  bytes += picture;
  return {
      {"asset", {{"version", "2.0"}}},
      {"buffers",
       {{{"byteLength", bytes.size()},
         {"uri", "data:application/octet-stream;base64," + base64(bytes)}}}},
      {"bufferViews",
       {{{"buffer", 0}, {"byteLength", size}},
        {{"buffer", 0}, {"byteOffset", size}, {"byteLength", picture.size()}}}},
      {"accessors", {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}}}},
      {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"material", 0}}}}}}},
      {"materials", {Json::object()}}};
}

MaterialLook look_of(const Json& json) {
  const MeshFile file = read_mesh(json.dump(), "a.gltf");
  EXPECT_EQ(file.looks.size(), file.mesh.material_names.size());
  return file.looks.at(0);
}

Json textured(const Json& image, const Json& reference = {{"index", 0}}) {
  Json json = document();
  json["images"] = Json::array({image});
  json["textures"] = {{{"source", 0}}};
  json["materials"][0]["pbrMetallicRoughness"] = {{"baseColorTexture", reference}};
  return json;
}

TEST(GltfLooks, TheFactorIsWhiteUnlessGiven) {
  EXPECT_EQ(look_of(document()).base_color, (Color{1, 1, 1, 1}));
  Json json = document();
  json["materials"][0]["pbrMetallicRoughness"] = {{"baseColorFactor", {0.5, 0.25, 0.125, 1}}};
  EXPECT_EQ(look_of(json).base_color, (Color{0.5f, 0.25f, 0.125f, 1}));
  EXPECT_FALSE(look_of(json).base_picture);
}

TEST(GltfLooks, AlphaCountsAsItsModeSays) {
  Json json = document();
  json["materials"][0]["pbrMetallicRoughness"] = {{"baseColorFactor", {1, 1, 1, 0.5}}};
  EXPECT_EQ(look_of(json).alpha, MaterialLook::Alpha::ignored);
  json["materials"][0]["alphaMode"] = "BLEND";
  EXPECT_EQ(look_of(json).alpha, MaterialLook::Alpha::blended);
  json["materials"][0]["alphaMode"] = "MASK";
  EXPECT_EQ(look_of(json).alpha, MaterialLook::Alpha::cut);
  EXPECT_EQ(look_of(json).alpha_cutoff, 0.5f);
  json["materials"][0]["alphaCutoff"] = 0.25;
  EXPECT_EQ(look_of(json).alpha_cutoff, 0.25f);
}

TEST(GltfLooks, WhatIsTransmittedHasAPictureOrNothingIsWhereItCannotBeRead) {
  Json json = textured({{"bufferView", 1}});
  Json& clear = json["materials"][0]["extensions"]["KHR_materials_transmission"];
  clear = Json::object();
  EXPECT_EQ(look_of(json).transmission, 0);
  clear["transmissionFactor"] = 0.75;
  EXPECT_EQ(look_of(json).transmission, 0.75f);
  clear["transmissionTexture"]["index"] = 0;
  EXPECT_EQ(look_of(json).transmission, 0.75f);
  EXPECT_EQ(*look_of(json).transmission_picture.bytes, "a picture");
  clear["transmissionTexture"]["texCoord"] = 1;
  EXPECT_EQ(look_of(json).transmission, 0);
}

TEST(GltfLooks, WhatIsSaidOfLightComesAsTheFormatHasIt) {
  const MaterialLook plain = look_of(document());
  EXPECT_EQ(plain.metallic, 1);
  EXPECT_EQ(plain.roughness, 1);
  EXPECT_EQ(plain.emission, (Color{0, 0, 0, 1}));
  Json json = textured({{"bufferView", 1}});
  Json& material = json["materials"][0];
  material["pbrMetallicRoughness"] = {{"metallicFactor", 0.25},
                                      {"roughnessFactor", 0.5},
                                      {"metallicRoughnessTexture", {{"index", 0}}}};
  material["normalTexture"] = {{"index", 0}, {"scale", 0.75}};
  material["occlusionTexture"] = {{"index", 0}, {"strength", 0.375}};
  material["emissiveFactor"] = {1, 0.5, 0};
  material["emissiveTexture"] = {{"index", 0}};
  material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 4}};
  const MaterialLook look = look_of(json);
  EXPECT_EQ(look.metallic, 0.25f);
  EXPECT_EQ(look.roughness, 0.5f);
  EXPECT_EQ(look.normal_strength, 0.75f);
  EXPECT_EQ(look.occlusion_strength, 0.375f);
  EXPECT_EQ(look.emission, (Color{4, 2, 0, 1}));
  EXPECT_FALSE(look.base_picture);
  for (const LookPicture* picture : {&look.metallic_roughness_picture, &look.normal_picture,
                                     &look.occlusion_picture, &look.emission_picture}) {
    EXPECT_TRUE(*picture);
    EXPECT_EQ(picture->bytes, look.normal_picture.bytes) << "held once";
  }
}

TEST(GltfLooks, NumbersBeyondTheirBoundsAreAtThem) {
  Json json = textured({{"bufferView", 1}});
  Json& material = json["materials"][0];
  material["pbrMetallicRoughness"] = {{"metallicFactor", -1}, {"roughnessFactor", 99}};
  material["normalTexture"] = {{"index", 0}, {"scale", 1e39}};
  material["alphaCutoff"] = -3;
  material["emissiveFactor"] = {1e38, 1, 0};
  material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 1e30}};
  const MaterialLook look = look_of(json);
  EXPECT_EQ(look.metallic, 0);
  EXPECT_EQ(look.roughness, 1);
  EXPECT_EQ(look.alpha_cutoff, 0);
  EXPECT_EQ(look.normal_strength, 1e6f);
  EXPECT_EQ(look.emission, (Color{1e6f, 1e6f, 0, 1}));
}

TEST(GltfLooks, TexturesInTheFileComeAsTheirBytesOthersByName) {
  const MaterialLook in_view = look_of(textured({{"bufferView", 1}, {"mimeType", "image/png"}}));
  ASSERT_TRUE(in_view.base_picture.bytes);
  EXPECT_EQ(*in_view.base_picture.bytes, "a picture");
  const std::string uri = "data:image/png;base64," + base64("another");
  const MaterialLook in_uri = look_of(textured({{"uri", uri}}));
  ASSERT_TRUE(in_uri.base_picture.bytes);
  EXPECT_EQ(*in_uri.base_picture.bytes, "another");
  const MaterialLook beside = look_of(textured({{"uri", "maps/brick.jpg"}}));
  EXPECT_FALSE(beside.base_picture.bytes);
  EXPECT_EQ(beside.base_picture.file, "maps/brick.jpg");
}

TEST(GltfLooks, TexturesGoOnAsTheirSamplerSays) {
  Json json = textured({{"bufferView", 1}});
  EXPECT_EQ(look_of(json).base_picture.wraps, TextureWraps{});
  json["samplers"] = Json::parse(R"([{"wrapS": 33071, "wrapT": 33648}])");
  json["textures"][0]["sampler"] = 0;
  EXPECT_EQ(look_of(json).base_picture.wraps,
            (TextureWraps{TextureWrap::clamp, TextureWrap::mirror}));
  json["textures"][0]["sampler"] = 7;
  EXPECT_EQ(look_of(json).base_picture.wraps, TextureWraps{});
}

TEST(GltfLooks, ATextureThatIsBrokenOrOfAnotherUvSetIsLeftOut) {
  const MeshFile broken = read_mesh(textured({{"bufferView", 7}}).dump(), "a.gltf");
  EXPECT_FALSE(broken.looks.at(0).base_picture);
  EXPECT_TRUE(std::any_of(broken.warnings.begin(), broken.warnings.end(), [](const auto& w) {
    return w.find("image 0 is not shown in pictures") != std::string::npos;
  }));
  EXPECT_FALSE(
      look_of(textured({{"bufferView", 1}}, {{"index", 0}, {"texCoord", 1}})).base_picture);
}

TEST(GltfLooks, TextureTransformsTurnAboutTheUpperLeftCorner) {
  const double r = 0.5;
  const Json transform{{"offset", {0.125, 0.25}}, {"rotation", r}, {"scale", {2, 3}}};
  const MaterialLook look = look_of(textured(
      {{"bufferView", 1}}, {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}));
  // The file's v runs down.
  const double u = 0.3, v = 0.6, down = 1 - v;
  const double to_u = std::cos(r) * 2 * u + std::sin(r) * 3 * down + 0.125;
  const double to_down = -std::sin(r) * 2 * u + std::cos(r) * 3 * down + 0.25;
  const Vec2 place = look.base_picture.place * Vec3(u, v, 1);
  EXPECT_NEAR(place.x(), to_u, 1e-14);
  EXPECT_NEAR(place.y(), 1 - to_down, 1e-14);
}

TEST(PlyLooks, TheOneTextureThatAFileNamesIsThatOfAllFaces) {
  const auto ply = [](const std::string& comments) {
    return "ply\nformat ascii 1.0\n" + comments +
           "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  };
  const MeshFile one = read_mesh(ply("comment TextureFile scan.png\n"), "a.ply");
  ASSERT_EQ(one.looks.size(), 1u);
  EXPECT_EQ(one.looks[0].base_picture.file, "scan.png");
  const std::string two = "comment TextureFile a.png\ncomment TextureFile b.png\n";
  EXPECT_TRUE(read_mesh(ply(two), "a.ply").looks.empty());
}

}  // namespace
}  // namespace craze
