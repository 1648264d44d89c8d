// A scene for tests with most of what glTF knows.
#pragma once

#include "io/gltf/scene/scene_file.h"

namespace craze {

/// A PNG of one pixel.
inline std::string small_png() {
  const std::string hex =
      "89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de0000000c494441"
      "54789c63386124020002d4010fd798ca390000000049454e44ae426082";
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

/// Two triangles, (0,0) (1,0) (1,1) (0,1), with what vertices can have.
inline Json square(SceneFile& file, std::size_t material) {
  Json primitive = Json::object();
  Json& a = primitive["attributes"];
  a["POSITION"] = file.add_positions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  a["NORMAL"] = file.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 5126, 3);
  a["TANGENT"] =
      file.add<float>({1, 0, 0, -1, 1, 0, 0, -1, 0, 1, 0, -1, 0, 1, 0, -1}, "VEC4", 5126, 4);
  a["TEXCOORD_0"] =
      file.add<std::uint16_t>({0, 0, 65535, 0, 65535, 65535, 0, 65535}, "VEC2", 5123, 2, true);
  a["TEXCOORD_1"] = file.add<float>({0, 0, 3, 0, 3, 3, 0, 3}, "VEC2", 5126, 2);
  a["COLOR_0"] =
      file.add<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 9, 9}, "VEC3", 5121, 3, true);
  a["_PART"] = file.add<std::uint16_t>({7, 7, 8, 8}, "SCALAR", 5123, 1);
  primitive["indices"] = file.add<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", 5123, 1);
  primitive["material"] = material;
  primitive["extras"] = {{"kind", "square"}};
  return primitive;
}

/// A body of two primitives under a turned and scaled parent, two wheels of one mesh, a flag on two
/// joints with a morph target, a camera, a light, an animation, a texture, and things unknown.
inline SceneFile truck() {
  SceneFile file;
  Json& json = file.json;
  json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_clearcoat", "VENDOR_unknown"};
  json["extensions"]["KHR_lights_punctual"]["lights"] =
      Json::parse(R"([{"name": "sun", "type": "directional"}])");
  json["extensions"]["VENDOR_unknown"]["table"] = {1, 2, 3};
  json["cameras"] = Json::parse(
      R"([{"name": "lens", "type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}])");
  json["images"] = Json::array(
      {{{"name", "paint"}, {"mimeType", "image/png"}, {"bufferView", file.add_view(small_png())}}});
  json["samplers"] = Json::parse(R"([{"wrapS": 33071}])");
  json["textures"] = Json::parse(R"([{"name": "paint", "sampler": 0, "source": 0}])");
  json["materials"] = Json::parse(R"([
    {"name": "paint", "alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorTexture":
      {"index": 0, "texCoord": 1}}, "extensions": {"KHR_materials_clearcoat":
      {"clearcoatFactor": 0.5}, "VENDOR_unknown": {"depth": 3}}, "extras": {"shop": "red"}},
    {"name": "crack_wall", "emissiveFactor": [0.1, 0.2, 0.3]}])");

  json["meshes"].push_back(
      {{"name", "body"}, {"primitives", {square(file, 0), square(file, 1)}}, {"extras", 5}});
  json["meshes"].push_back({{"name", "wheel"}, {"primitives", {square(file, 1)}}});
  Json flag = square(file, 0);
  flag["attributes"]["JOINTS_0"] =
      file.add<std::uint8_t>({0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 5121, 4);
  flag["attributes"]["WEIGHTS_0"] = file.add<float>(
      {0.75f, 0.25f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", 5126, 4);
  flag["targets"] = {{{"POSITION", file.add_positions({0, 0, 0, 0, 0, 2, 0, 0, 2, 0, 0, 0})}}};
  json["meshes"].push_back({{"name", "flag"}, {"primitives", {flag}}, {"weights", {0.5}}});
  std::vector<float> inverse(32, 0);
  for (std::size_t i = 0; i < 32; i += 5) inverse[i % 16 + i / 16 * 16] = 1;
  for (std::size_t i = 0; i < 4; ++i) inverse[5 * i] = inverse[16 + 5 * i] = 1;
  json["skins"] = Json::array({{{"name", "bones"},
                                {"joints", {6, 7}},
                                {"inverseBindMatrices", file.add(inverse, "MAT4", 5126, 16)}}});

  json["nodes"] = Json::parse(R"([
    {"name": "truck", "children": [1, 2, 3], "rotation": [0, 0, 0.6, 0.8], "scale": [2, 2, 2]},
    {"name": "chassis", "mesh": 0, "translation": [5, 0, 0]},
    {"name": "left wheel", "mesh": 1, "translation": [0, 3, 0], "extras": {"axle": 1}},
    {"name": "right wheel", "mesh": 1, "translation": [0, -3, 0]},
    {"name": "eye", "camera": 0},
    {"name": "banner", "mesh": 2, "skin": 0},
    {"name": "pole", "children": [7], "translation": [0, 0, 9]},
    {"name": "tip", "translation": [0, 0, 1], "rotation": [0, 0, 0.6, 0.8]},
    {"name": "sun", "extensions": {"KHR_lights_punctual": {"light": 0}}}])");
  json["scenes"][0]["nodes"] = {0, 4, 5, 6, 8};
  json["animations"] = Json::array();
  const std::size_t times = file.add<float>({0, 1}, "SCALAR", 5126, 1);
  const std::size_t turns = file.add<float>({0, 0, 0, 1, 0, 0, 1, 0}, "VEC4", 5126, 4);
  const std::size_t waves = file.add<float>({0, 1}, "SCALAR", 5126, 1);
  json["animations"].push_back(
      {{"name", "drive"},
       {"samplers", {{{"input", times}, {"output", turns}}, {{"input", times}, {"output", waves}}}},
       {"channels",
        {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "rotation"}}}},
         {{"sampler", 1}, {"target", {{"node", 5}, {"path", "weights"}}}}}}});
  return file;
}

/// Faces of the truck as it is read.
inline constexpr std::int32_t body = 0, second_body = 2, left_wheel = 4, right_wheel = 6,
                              banner = 8;

inline MeshFile read(const SceneFile& file) {
  return read_mesh(file.bytes(), "truck.glb");
}

}  // namespace craze
