// Pictures of glTF scenes whose textures lie in other UV sets than the first.
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "craze/io/image/encode_png.h"
#include "craze/io/image/read_image.h"
#include "io/gltf/scene/scene_file.h"

namespace craze {
namespace {

/// A unit square whose picture is red on the left and green on the right, at the UVs `set`, and
/// whose other sets below `sets` lie on its red.
SceneFile two_colors(int set, int sets, int asked) {
  SceneFile file;
  Json& json = file.json;
  Image image{2, 1, 3, {}};
  image.values = std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0};
  json["images"].push_back(
      {{"mimeType", "image/png"}, {"bufferView", file.add_view(encode_png(image))}});
  json["textures"] = Json::parse(R"([{"source": 0}])");
  json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0},
                                                                      {"texCoord", asked}};
  const std::vector<float> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, uvs{0, 0, 1, 0, 1, 1, 0, 1},
      left(8, 0.25f);
  Json primitive;
  primitive["attributes"]["POSITION"] = file.add_positions(points);
  for (int n = 0; n < sets; ++n) {
    primitive["attributes"]["TEXCOORD_" + std::to_string(n)] =
        file.add(n == set ? uvs : left, "VEC2", 5126, 2);
  }
  primitive["indices"] = file.add(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR", 5123, 1);
  primitive["material"] = 0;
  json["meshes"].push_back({{"primitives", {primitive}}});
  json["nodes"].push_back({{"mesh", 0}});
  json["scenes"][0]["nodes"].push_back(0);
  return file;
}

class FurtherUvSets : public CommandTest {
 protected:
  /// The parts of a picture that are red and green, by `craze render` or by other words.
  std::array<double, 2> colors(const SceneFile& scene, CommandResult& result,
                               std::vector<std::string> words = {"render", "a.glb", "-o",
                                                                 "a.png"}) {
    std::ofstream(file("a.glb"), std::ios::binary) << scene.bytes();
    words.insert(words.end(), {"--width", "64", "--height", "64", "--up", "y", "--azimuth", "0",
                               "--elevation", "0", "--no-ground"});
    result = run(words);
    EXPECT_EQ(result.code, 0) << result.err;
    const Image picture = read_image(read_text(file("a.png")), "a.png");
    std::array<double, 2> part{};
    const double pixel = 1.0 / picture.width / picture.height;
    for (std::int32_t y = 0; y < picture.height; ++y) {
      for (std::int32_t x = 0; x < picture.width; ++x) {
        const double red = picture.value(x, y, 0), green = picture.value(x, y, 1);
        if (red > 2 * green) part[0] += pixel;
        if (green > 2 * red) part[1] += pixel;
      }
    }
    return part;
  }
};

TEST_F(FurtherUvSets, AreShownInPictures) {
  for (const int set : {0, 1, 2}) {
    CommandResult result;
    const auto [red, green] = colors(two_colors(set, 3, set), result);
    EXPECT_GT(red, 0.1) << set;
    EXPECT_NEAR(red, green, 0.1) << set;
    EXPECT_EQ(result.err, "") << set;
  }
}

TEST_F(FurtherUvSets, AreShownInPicturesOfRuns) {
  const std::vector<std::string> cracking{
      "crack", "a.glb",  "--preset",     "mud", "--set",     "layer.relative_spacing=0.3",
      "--set", "seed=1", "--max-cracks", "30",  "--picture", "a.png"};
  std::vector<std::string> opened = cracking, simulated = cracking;
  opened.insert(opened.end(), {"--set", "post.gap=0.02", "--set", "post.wall=0.02"});
  simulated.insert(simulated.end(), {"--set", "mesh.output=\"simulation\""});
  for (const auto& words : {cracking, opened}) {
    CommandResult result;
    const auto [red, green] = colors(two_colors(1, 2, 1), result, words);
    EXPECT_GT(red, 0.1);
    EXPECT_NEAR(red, green, 0.1);
    EXPECT_EQ(result.err.find("UV set"), std::string::npos) << result.err;
  }
  CommandResult result;
  const auto [red, green] = colors(two_colors(1, 2, 1), result, simulated);
  EXPECT_EQ(red + green, 0);
  EXPECT_NE(result.err.find("further UV set"), std::string::npos) << result.err;
}

TEST_F(FurtherUvSets, ThatAreNotThereAreSaid) {
  for (const int asked : {2, 5, 2'000'000'000}) {
    CommandResult result;
    const auto [red, green] = colors(two_colors(0, 2, asked), result);
    EXPECT_EQ(red + green, 0) << asked;
    EXPECT_NE(result.err.find("textures read TEXCOORD_" + std::to_string(asked)), std::string::npos)
        << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

TEST_F(FurtherUvSets, MayBeginWithAnotherThanTheFirst) {
  SceneFile scene = two_colors(1, 2, 1);
  scene.json["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0");
  CommandResult result;
  const auto [red, green] = colors(scene, result);
  EXPECT_GT(red, 0.1);
  EXPECT_NEAR(red, green, 0.1);
  EXPECT_EQ(result.err, "");
  const CommandResult maps =
      run({"crack", "a.glb", "--preset", "mud", "--map-size", "64", "--as", "maps", "-o", "b.glb"});
  EXPECT_EQ(maps.code, 0) << maps.err;
  EXPECT_EQ(maps.err.find("missing"), std::string::npos) << maps.err;
}

}  // namespace
}  // namespace craze
