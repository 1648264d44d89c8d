// Maps of scenes whose own UVs are no place for them.
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "craze/base/surface_pictures.h"
#include "craze/io/image/encode_png.h"
#include "craze/io/image/read_image.h"
#include "craze/products/maps/pictures/sample_picture.h"
#include "io/gltf/scene/scene_file.h"

namespace craze {
namespace {

constexpr int cells = 8;

/// A plate of 2 n² triangles, its UVs `times` as large as the picture.
Json plate(SceneFile& file, int material, double times) {
  std::vector<float> points, normals, uvs;
  std::vector<std::uint16_t> corners;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const float u = static_cast<float>(i) / cells, v = static_cast<float>(j) / cells;
      points.insert(points.end(), {u, v, 0});
      normals.insert(normals.end(), {0, 0, 1});
      uvs.push_back(static_cast<float>(times) * u);
      uvs.push_back(static_cast<float>(times) * v);
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto a = static_cast<std::uint16_t>(j * (cells + 1) + i);
      const auto next = [a](int k) { return static_cast<std::uint16_t>(a + k); };
      corners.insert(corners.end(),
                     {a, next(1), next(cells + 2), a, next(cells + 2), next(cells + 1)});
    }
  }
  Json primitive;
  primitive["attributes"] = {{"POSITION", file.add_positions(points)},
                             {"NORMAL", file.add(normals, "VEC3", 5126, 3)}};
  if (times > 0) primitive["attributes"]["TEXCOORD_0"] = file.add(uvs, "VEC2", 5126, 2);
  primitive["indices"] = file.add(corners, "SCALAR", 5123, 1);
  primitive["material"] = material;
  return primitive;
}

/// Brick that repeats on a mesh that two nodes show, clay without UVs, glass, and tin that has all
/// it needs.
SceneFile yard() {
  SceneFile file;
  Json& json = file.json;
  Image ramp{16, 16, 3, {}};
  std::vector<std::uint8_t> values;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      for (const int c : {100 + 4 * x, 100 + 4 * y, 180}) {
        values.push_back(static_cast<std::uint8_t>(c));
      }
    }
  }
  ramp.values = std::move(values);
  json["images"].push_back(
      {{"mimeType", "image/png"}, {"bufferView", file.add_view(encode_png(ramp))}});
  json["textures"] = Json::parse(R"([{"source": 0}])");
  json["materials"] = Json::parse(R"([
    {"name": "brick", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
     "emissiveTexture": {"index": 0}},
    {"name": "clay"}, {"name": "glass"},
    {"name": "tin", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}])");
  json["meshes"].push_back({{"name", "wall"}, {"primitives", {plate(file, 0, 3)}}});
  json["meshes"].push_back({{"name", "pot"}, {"primitives", {plate(file, 1, 0)}}});
  json["meshes"].push_back({{"name", "pane"}, {"primitives", {plate(file, 2, 0)}}});
  json["meshes"].push_back({{"name", "can"}, {"primitives", {plate(file, 3, 1)}}});
  int n = 0;
  for (const int mesh : {0, 0, 1, 2, 3}) {
    json["nodes"].push_back({{"mesh", mesh}, {"translation", {1.5 * n, 0, 0}}});
    json["scenes"][0]["nodes"].push_back(n++);
  }
  return file;
}

class SceneMaps : public CommandTest {
 protected:
  CommandResult crack(const std::vector<std::string>& more, const char* size = "128") {
    std::ofstream(file("yard.glb"), std::ios::binary) << yard().bytes();
    std::vector<std::string> all{"crack",    "yard.glb",
                                 "--preset", "mud",
                                 "--set",    "where.materials=[\"brick\",\"clay\",\"tin\"]"};
    const bool has_maps = std::any_of(more.begin(), more.end(), [](const std::string& word) {
      return word == "--maps" || word == "maps";
    });
    if (has_maps) all.insert(all.end(), {"--map-size", size});
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
  SceneFile scene(const char* name) const { return SceneFile(read_text(file(name))); }
};

TEST_F(SceneMaps, LieInAFurtherUvSetWhereTheOwnOnesRepeatOrAreMissing) {
  const CommandResult result = crack({"--as", "maps", "-o", "out.glb", "--report", "r.json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("the UVs of 'brick' overlap, those of 'clay' are missing (maps)"),
            std::string::npos)
      << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  const Json report = Json::parse(read_text(file("r.json")));
  EXPECT_NE(report["warnings"].dump().find("TEXCOORD_1"), std::string::npos);
  const SceneFile before = yard(), after = scene("out.glb");
  const Json &brick = after.json["materials"][0], &clay = after.json["materials"][1];
  for (const Json& material : {brick, clay}) {
    EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"], 1);
    EXPECT_EQ(material["normalTexture"]["texCoord"], 1);
    EXPECT_EQ(material["occlusionTexture"]["texCoord"], 1);
  }
  EXPECT_EQ(brick["emissiveTexture"], before.json["materials"][0]["emissiveTexture"]);
  // What has UVs of its own, and what does not crack.
  const Json& tin = after.json["materials"][3];
  EXPECT_FALSE(tin["pbrMetallicRoughness"]["baseColorTexture"].contains("texCoord"));
  EXPECT_EQ(after.json["materials"][2], before.json["materials"][2]);
  const auto attributes = [&](std::size_t node) -> Json {
    return after.primitive(after.json["nodes"][node]["mesh"], 0)["attributes"];
  };
  EXPECT_NE(attributes(0)["TEXCOORD_1"], attributes(1)["TEXCOORD_1"]);
  EXPECT_TRUE(attributes(2).contains("TEXCOORD_0"));
  EXPECT_FALSE(attributes(3).contains("TEXCOORD_0"));
  EXPECT_FALSE(attributes(4).contains("TEXCOORD_1"));
  for (const std::size_t node : {0, 1, 2, 3, 4}) {
    const Json& old = before.primitive(before.json["nodes"][node]["mesh"], 0)["attributes"];
    for (const auto& [name, accessor] : old.items()) {
      const std::string was = before.elements(accessor);
      EXPECT_EQ(after.elements(attributes(node)[name]).substr(0, was.size()), was) << name;
    }
  }
}

// Of every point of the surface that no crack is near, in light that a texel of 8 bits can hold.
TEST_F(SceneMaps, ShowTheOwnPicturesWhereTheyWere) {
  ASSERT_EQ(
      crack({"--as", "maps", "-o", "out.glb", "--stain", "000000", "--no-warnings"}, "1024").code,
      0);
  const SceneFile after = scene("out.glb");
  const std::size_t texture =
      after.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"];
  const auto picture_of = [&](std::size_t t) {
    const Json& image = after.json["images"][after.json["textures"][t]["source"].get<int>()];
    return SurfacePicture{read_image(after.view(image["bufferView"]), "image")};
  };
  const SurfacePicture was = picture_of(after.json["materials"][0]["emissiveTexture"]["index"]),
                       is = picture_of(texture);
  const PictureSampler before(was), cracked(is);
  int same = 0, dark = 0, all = 0;
  for (const std::size_t node : {0, 1}) {
    const Json& primitive = after.primitive(after.json["nodes"][node]["mesh"], 0);
    const std::vector<float> own = after.floats(primitive["attributes"]["TEXCOORD_0"]),
                             made = after.floats(primitive["attributes"]["TEXCOORD_1"]);
    const std::string indices = after.elements(primitive["indices"]);
    const int width =
        after.json["accessors"][primitive["indices"].get<std::size_t>()]["componentType"] == 5121
            ? 1
            : 2;
    for (std::size_t i = 0; i < indices.size(); i += 3 * static_cast<std::size_t>(width)) {
      const auto middle = [&](const std::vector<float>& uvs) {
        Vec2 sum(0, 0);
        const Vec3 weights(0.5, 0.2, 0.3);
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t at = i + k * static_cast<std::size_t>(width);
          const std::size_t v = width == 1 ? static_cast<std::uint8_t>(indices[at])
                                           : load<std::uint16_t>(indices.data() + at);
          sum += weights[static_cast<int>(k)] * Vec2(uvs[2 * v], 1 - uvs[2 * v + 1]);
        }
        return sum;
      };
      const Color a = before.color(middle(own)), b = cracked.color(middle(made));
      ++all;
      same += std::abs(a[0] - b[0]) < 0.015 && std::abs(a[1] - b[1]) < 0.015;
      dark += b[2] < a[2] - 0.05;
    }
  }
  EXPECT_EQ(all, 2 * 2 * cells * cells);
  EXPECT_GT(same, all * 8 / 10);
  EXPECT_GE(same + dark, all * 98 / 100);
}

TEST_F(SceneMaps, AsFilesSayTheirUvSetAndCutScenesBringIt) {
  const CommandResult result = crack({"--maps", "m", "--map", "mask", "-o", "out.glb"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Json maps = Json::parse(read_text(file("m") / "maps.json"))["maps"];
  std::map<std::string, int> sets;
  for (const Json& map : maps) sets[map["texture_set"]] = map["uv_set"];
  // With files glass has maps too.
  EXPECT_EQ(sets,
            (std::map<std::string, int>{{"brick", 1}, {"clay", 1}, {"glass", 1}, {"tin", 0}}));
  const SceneFile after = scene("out.glb");
  const Json& wall = after.primitive(after.json["nodes"][0]["mesh"], 0);
  EXPECT_TRUE(wall["attributes"].contains("TEXCOORD_1"));
  EXPECT_EQ(after.json["materials"][0], yard().json["materials"][0]);
  const CommandResult alone = crack({"--maps", "n", "--map", "mask"});
  EXPECT_NE(alone.err.find("-o FILE.glb writes the scene with them"), std::string::npos)
      << alone.err;
}

// What was made for maps is not missed where only the cut surface is written.
TEST_F(SceneMaps, LeaveWhatIsSaidOfOtherFormatsAsItIs) {
  const auto lost = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"-o", "x.ply"});
    const std::string all = crack(more).err;
    return all.substr(std::min(all.find("not kept of the input"), all.size()));
  };
  EXPECT_FALSE(lost({}).empty());
  EXPECT_EQ(lost({"--maps", "m", "--map", "mask"}), lost({}));
}

TEST_F(SceneMaps, OfARemeshedSurfaceWithoutUvsAreRefusedBeforeItCracks) {
  SceneFile bare;
  bare.json["materials"] = Json::parse(R"([{"name": "clay"}])");
  bare.json["meshes"].push_back({{"primitives", {plate(bare, 0, 0)}}});
  bare.json["nodes"].push_back({{"mesh", 0}});
  bare.json["scenes"][0]["nodes"] = {0};
  std::ofstream(file("bare.glb"), std::ios::binary) << bare.bytes();
  const std::vector<std::string> arguments{"crack", "bare.glb",   "--preset", "mud",  "--maps",
                                           "m",     "--map-size", "16",       "--set"};
  const auto with = [&](const char* setting) {
    std::vector<std::string> all = arguments;
    all.emplace_back(setting);
    return run(all);
  };
  const CommandResult refused = with("mesh.output=\"simulation\"");
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("no UVs"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(file("m")));
  EXPECT_EQ(with("mesh.output=\"asset\"").code, 0);
  const CommandResult parts =
      crack({"--as", "maps", "-o", "x.glb", "--set", "mesh.output=\"simulation\""});
  EXPECT_EQ(parts.code, 1);
  EXPECT_NE(parts.err.find("parts with no UVs"), std::string::npos) << parts.err;
}

TEST_F(SceneMaps, AreTheSameBytesOnAnyNumberOfThreads) {
  ASSERT_EQ(crack({"--as", "maps", "-o", "one.glb", "--threads", "1", "--no-warnings"}).code, 0);
  ASSERT_EQ(crack({"--as", "maps", "-o", "three.glb", "--threads", "3", "--no-warnings"}).code, 0);
  EXPECT_EQ(read_text(file("one.glb")), read_text(file("three.glb")));
}

}  // namespace
}  // namespace craze
