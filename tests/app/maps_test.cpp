// Maps of the command: which files there are, and what is said beside them.
#include <cstring>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "craze/io/image/read_image.h"

namespace craze {
namespace {

class MapFiles : public CommandTest {
 protected:
  nlohmann::json description(const std::string& folder) const {
    return nlohmann::json::parse(read_text(file(folder) / "maps.json"));
  }
};

TEST_F(MapFiles, AreThoseAskedForAndAreDescribed) {
  const CommandResult result =
      run({"crack", "shape:plate?n=12", "--preset", "mud", "--max-cracks", "20", "--maps", "a/b",
           "--map", "mask", "--map", "normal,crack", "--map-size", "48", "--quiet"});
  ASSERT_EQ(result.code, 0) << result.err;
  const nlohmann::json json = description("a/b");
  ASSERT_EQ(json["maps"].size(), 3u);
  for (const auto& map : json["maps"]) {
    const Image image = read_image_file(file("a/b") / map["file"].get<std::string>());
    EXPECT_EQ(image.width, 48);
    EXPECT_EQ(image.height, 48);
    EXPECT_EQ(image.channels, map["channels"].get<int>());
    EXPECT_EQ(map["color_space"], "linear");
  }
  EXPECT_EQ(json["maps"][1]["green"], "up");
  EXPECT_EQ(json["maps"][2]["values"], "id");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file("a/b")), {}), 4);
}

TEST_F(MapFiles, OfACrackedMeshAreThoseOfTheRun) {
  ASSERT_EQ(run({"crack", "shape:plate?n=12", "--preset", "mud", "-o", "cut.ply", "--maps", "one",
                 "--map", "distance,mask,fragment", "--map-size", "64", "--quiet"})
                .code,
            0);
  const CommandResult result = run({"bake", "cut.ply", "-o", "two", "--map",
                                    "distance,mask,fragment", "--map-size", "64", "--quiet"});
  ASSERT_EQ(result.code, 0) << result.err;
  const nlohmann::json maps = description("one")["maps"];
  for (const auto& map : maps) {
    const std::string name = map["file"];
    const Image one = read_image_file(file("one") / name),
                two = read_image_file(file("two") / name);
    double worst = 0;
    for (int i = 0; i < 64 * 64; ++i) {
      worst =
          std::max(worst, std::abs(one.value(i % 64, i / 64, 0) - two.value(i % 64, i / 64, 0)));
    }
    EXPECT_LT(worst, name == "fragment.png" ? 1e-9 : 1e-3) << name;
  }
}

/// Mean difference of two grey maps of 64 × 64 texels, as a part of their range.
double mean_difference(const std::filesystem::path& a, const std::filesystem::path& b) {
  const Image one = read_image_file(a), two = read_image_file(b);
  double sum = 0;
  for (int i = 0; i < 64 * 64; ++i) {
    sum += std::abs(one.value(i % 64, i / 64, 0) - two.value(i % 64, i / 64, 0));
  }
  return sum / (64 * 64);
}

TEST_F(MapFiles, OfACrackedMeshKnowHowOldItsCracksAre) {
  // Hairlines, which are as wide as they are old.
  const auto width_map = [&](std::vector<std::string> arguments, const char* folder, bool late) {
    for (const char* more : {folder, "--map", "width", "--map-size", "64", "--quiet"}) {
      arguments.emplace_back(more);
    }
    if (late) {
      arguments.emplace_back("--set");
      arguments.emplace_back("post.late_width=0.2");
    }
    const CommandResult result = run(arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return file(folder) / "width.png";
  };
  width_map({"crack", "shape:plate?n=12", "--preset", "mud", "-o", "cut.ply", "--maps"}, "even",
            false);
  const auto of_run =
      width_map({"crack", "shape:plate?n=12", "--preset", "mud", "--maps"}, "one", true);
  const auto of_file = width_map({"bake", "cut.ply", "-o"}, "two", true);
  const double apart = mean_difference(of_run, of_file);
  EXPECT_LT(apart, 0.01);
  EXPECT_GT(mean_difference(file("even/width.png"), of_file), 10 * apart);
}

TEST_F(MapFiles, OfACrackedMeshSayWhatTheFileDoesNotTell) {
  ASSERT_EQ(run({"crack", "shape:plate?n=12", "--preset", "mud", "-o", "cut.obj", "--quiet",
                 "--no-warnings"})
                .code,
            0);
  const CommandResult result =
      run({"bake", "cut.obj", "-o", "maps", "--map", "width", "--map-size", "64", "--gap", "0.1",
           "--set", "post.late_width=0.2", "--quiet"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("post.gap is left out"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("post.late_width is left out"), std::string::npos) << result.err;
  for (const char* setting : {"layer.spacing=1", "post.thickness=1", "post.late_width=2",
                              "post.gap=-1", "post.curl=x", "no.key=1", "impact.0.radius=2"}) {
    const CommandResult refused = run({"bake", "cut.obj", "-o", "no", "--set", setting});
    EXPECT_EQ(refused.code, 2) << setting;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
  EXPECT_EQ(run({"bake", "cut.obj", "-o", "no", "--gap", "0.1", "--set", "post.gap_width=1"}).code,
            2);
}

TEST_F(MapFiles, AreTheSameBytesOnAnyNumberOfThreads) {
  for (const char* threads : {"1", "3"}) {
    ASSERT_EQ(run({"crack", "shape:cup", "--preset", "mud", "--max-cracks", "30", "--maps", threads,
                   "--map-size", "100", "--threads", threads, "--quiet"})
                  .code,
              0);
  }
  for (const auto& entry : std::filesystem::directory_iterator(file("1"))) {
    EXPECT_EQ(read_text(entry.path()), read_text(file("3") / entry.path().filename()))
        << entry.path();
  }
}

/// The JSON of a GLB.
nlohmann::json json_of(const std::string& glb) {
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, sizeof size);
  return nlohmann::json::parse(glb.substr(20, size));
}

TEST_F(MapFiles, CanBeTheMaterialsOfAMeshThatIsNotCut) {
  ASSERT_EQ(run({"crack", "shape:cup?n=24", "-o", "plain.glb", "--max-cracks", "0", "--preset",
                 "glaze", "--quiet"})
                .code,
            0);
  for (const char* name : {"one.glb", "two.glb"}) {
    const CommandResult result = run({"crack", "plain.glb", "-o", name, "--as", "maps",
                                      "--map-size", "64", "--preset", "mud", "--max-cracks", "20",
                                      "--stain", "3b2314", "--threads", *name == 'o' ? "1" : "3"});
    ASSERT_EQ(result.code, 0) << result.err;
  }
  EXPECT_EQ(read_text(file("one.glb")), read_text(file("two.glb")));
  const nlohmann::json before = json_of(read_text(file("plain.glb"))),
                       after = json_of(read_text(file("one.glb")));
  EXPECT_EQ(after["meshes"], before["meshes"]);
  EXPECT_EQ(after["accessors"], before["accessors"]);
  const nlohmann::json& material = after["materials"][0];
  for (const char* key : {"normalTexture", "occlusionTexture"}) EXPECT_TRUE(material.contains(key));
  EXPECT_TRUE(material["pbrMetallicRoughness"].contains("baseColorTexture"));
  EXPECT_TRUE(material["pbrMetallicRoughness"].contains("metallicRoughnessTexture"));
}

TEST_F(MapFiles, AsMaterialsGetUvsWhereTheMeshHasNone) {
  ASSERT_EQ(run({"crack", "shape:cup?n=24", "-o", "cup.stl", "--max-cracks", "0", "--preset",
                 "glaze", "--quiet"})
                .code,
            0);
  const CommandResult result =
      run({"crack", "cup.stl", "-o", "cup.glb", "--as", "maps", "--map-size", "64", "--preset",
           "mud", "--max-cracks", "20", "--report", "cup.json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("no UVs"), std::string::npos) << result.err;
  const nlohmann::json glb = json_of(read_text(file("cup.glb"))),
                       report = nlohmann::json::parse(read_text(file("cup.json")));
  const nlohmann::json& primitive = glb["meshes"][0]["primitives"][0];
  EXPECT_TRUE(primitive["attributes"].contains("TEXCOORD_0"));
  const std::size_t indices = primitive["indices"];
  EXPECT_EQ(glb["accessors"][indices]["count"].get<int>(),
            3 * report["input"]["triangles"].get<int>());
  EXPECT_EQ(report["output"]["triangles"], report["input"]["triangles"]);
  // A scene whose geometry is kept gets a set.
  ASSERT_EQ(
      run({"crack", "cup.stl", "-o", "bare.glb", "--max-cracks", "0", "--preset", "mud"}).code, 0);
  EXPECT_TRUE(
      json_of(read_text(file("bare.glb")))["meshes"][0]["primitives"][0]["attributes"].contains(
          "NORMAL"))
      << "viewers would shade it flat";
  const CommandResult kept = run({"crack", "bare.glb", "-o", "b.glb", "--as", "maps", "--map-size",
                                  "64", "--preset", "mud", "--max-cracks", "20"});
  ASSERT_EQ(kept.code, 0) << kept.err;
  EXPECT_NE(kept.err.find("are missing (maps)"), std::string::npos) << kept.err;
  EXPECT_TRUE(
      json_of(read_text(file("b.glb")))["meshes"][0]["primitives"][0]["attributes"].contains(
          "TEXCOORD_0"));
}

TEST_F(MapFiles, AsMaterialsAreRefusedWhereTheyCannotBe) {
  expect_error({"crack", "shape:plate", "--as", "maps", "-o", "a.ply"}, 2, ".glb");
  expect_error({"crack", "shape:plate", "--as", "maps", "--report", "a.json"}, 2, "-o FILE.glb");
  expect_error({"crack", "shape:plate", "--as", "maps", "-o", "a.glb", "--fragments"}, 2,
               "not cut");
  expect_error({"crack", "shape:plate", "--as", "maps", "-o", "a.glb", "--stain", "brown"}, 2,
               "--stain");
}

TEST_F(MapFiles, ThatCannotBeAreRefusedInOneLine) {
  expect_error({"crack", "shape:plate", "--maps", "m", "--map", "masc"}, 2, "mask");
  expect_error({"crack", "shape:plate", "--maps", "m", "--map-size", "9000"}, 2, "map-size");
  expect_error({"crack", "shape:plate?n=4", "--maps", "/proc/maps"}, 1, "cannot write maps");
}

TEST_F(MapFiles, GiveAMeshWithoutUvsSomeAndLeaveItsCracksAlone) {
  ASSERT_EQ(run({"crack", "shape:sphere?n=16", "-o", "ball.stl", "--max-cracks", "0", "--preset",
                 "glaze", "--quiet"})
                .code,
            0);
  const std::vector<std::string> cracked{"crack", "ball.stl",       "--preset", "mud",
                                         "--set", "mesh.edge=keep", "--lines"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), cracked.begin(), cracked.end());
    return run(more);
  };
  ASSERT_EQ(with({"plain.json", "-o", "plain.glb"}).code, 0);
  const CommandResult result = with(
      {"mapped.json", "-o", "mapped.glb", "--maps", "m", "--map-size", "256", "--map", "mask"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("has no UVs (maps): others were made for it, in "), std::string::npos)
      << result.err;
  EXPECT_EQ(result.err.find("overlap"), std::string::npos) << result.err;
  const nlohmann::json glb = json_of(read_text(file("mapped.glb")));
  EXPECT_TRUE(glb["meshes"][0]["primitives"][0]["attributes"].contains("TEXCOORD_0"));
  const auto lines = [&](const char* name) {
    return nlohmann::json::parse(read_text(file(name)))["points"];
  };
  EXPECT_EQ(lines("plain.json"), lines("mapped.json"));
  EXPECT_TRUE(std::filesystem::exists(file("m") / "mask.png"));
  const CommandResult alone = with({"alone.json", "--maps", "n", "--map-size", "16"});
  EXPECT_NE(alone.err.find("-o writes the mesh with them"), std::string::npos) << alone.err;
}

TEST_F(MapFiles, OfAMeshWithoutCracksAreRefused) {
  const CommandResult result = run({"bake", "shape:plate?n=4", "-o", "m"});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.err.find("no cracks to bake"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace craze
