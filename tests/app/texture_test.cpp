// craze texture: which files there are, what they say of themselves, what is refused.
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "craze/io/image/read_image.h"

namespace craze {
namespace {

class TextureFiles : public CommandTest {
 protected:
  CommandResult texture(const std::string& folder, std::vector<std::string> more) {
    std::vector<std::string> line{"texture", "mud", "-o",    folder,
                                  "--size",  "64",  "--set", "layer.relative_spacing=0.15",
                                  "--quiet"};
    line.insert(line.end(), more.begin(), more.end());
    return run(line);
  }
};

TEST_F(TextureFiles, AreThoseOfTheMaterialAndAreDescribed) {
  const CommandResult result = texture("set", {"--no-previews", "--period", "40cm"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto json = nlohmann::json::parse(read_text(file("set") / "maps.json"));
  EXPECT_EQ(json["tile"]["side"], 0.4);
  EXPECT_EQ(json["tile"]["metres_per_unit"], 1);
  EXPECT_GT(json["tile"]["gap"], 0);  // mud gapes
  std::vector<std::string> names;
  for (const auto& map : json["maps"]) {
    const std::string name = map["map"], path = map["file"];
    names.push_back(name);
    const Image image = read_image_file(file("set") / path);
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.channels, map["channels"].get<int>());
    const bool is_color = name == "base_color";
    EXPECT_EQ(map["color_space"], is_color ? "sRGB" : "linear");
    const std::string head = read_text(file("set") / path).substr(0, 64);
    EXPECT_NE(head.find(is_color ? "sRGB" : "gAMA"), std::string::npos) << path;
    EXPECT_EQ(head.find(is_color ? "gAMA" : "sRGB"), std::string::npos) << path;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"base_color", "normal", "height", "occlusion",
                                             "roughness", "mask", "fragment"}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file("set")), {}), 8);
}

TEST_F(TextureFiles, NameKeysThatATileHasNoUseFor) {
  const CommandResult result =
      texture("set", {"--no-previews", "--map", "mask", "--set", "post.thickness=0.1", "--set",
                      "post.core=true", "--set", "mesh.edge=keep"});
  EXPECT_EQ(result.err,
            "craze: warning: a tile is flat and in one piece: what does nothing (mesh.edge, "
            "post.thickness, post.core)\n");
}

TEST_F(TextureFiles, AreTheSameBytesOnAnyNumberOfThreadsAndOthersWithAnotherSeed) {
  ASSERT_EQ(texture("one", {"--threads", "1"}).code, 0);
  ASSERT_EQ(texture("three", {"--threads", "3", "--no-previews"}).code, 0);
  ASSERT_EQ(texture("other", {"--seed", "2", "--no-previews"}).code, 0);
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(file("three"))) {
    const auto name = entry.path().filename();
    EXPECT_EQ(read_text(entry.path()), read_text(file("one") / name)) << name;
    ++files;
  }
  EXPECT_EQ(files, 8);
  for (const char* preview : {"preview_plane.png", "preview_sphere.png"}) {
    EXPECT_GT(read_image_file(file("one") / preview).width, 0) << preview;
  }
  EXPECT_NE(read_text(file("one") / "mask.png"), read_text(file("other") / "mask.png"));
}

TEST_F(TextureFiles, AreRefusedInOneLineWhereTheyCannotBe) {
  const auto refused = [&](std::vector<std::string> more, int code, const char* why) {
    const CommandResult result = texture("none", std::move(more));
    EXPECT_EQ(result.code, code) << result.err;
    EXPECT_NE(result.err.find(why), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(file("none")));
  };
  refused({"--period", "0"}, 2, "wrong period");
  refused({"--period", "5%"}, 2, "wrong period");
  refused({"--map", "position"}, 2, "tiles have no such map");
  refused({"--map", "base_colour"}, 2, "did you mean base_color?");
  refused({"--set", "layer.spacing=0.9"}, 1, "tile too small for its pattern");
  refused({"--set", "stress.attribute=drying"}, 1, "drying");
}

TEST_F(TextureFiles, HaveAMaterialThatMapsOfSurfacesHaveNot) {
  const CommandResult result =
      run({"crack", "shape:plate?n=8", "--maps", "m", "--map", "base_color", "--quiet"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("unknown map"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace craze
