// The growth of the cracks and the fragments, as the command writes them.
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "craze/error.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/read_mesh.h"

namespace craze {
namespace {

const std::vector<std::string> mud{"crack", "shape:plate?n=16&jitter=0.3", "--preset", "mud",
                                   "--set", "layer.relative_spacing=0.15"};
const std::vector<std::string> gaps{"--set", "post.gap=0.1", "--set", "post.wall=0.02"};
const std::vector<std::string> small{"--width", "160", "--height", "120"};

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

nlohmann::json glb_json(const std::filesystem::path& path) {
  const std::string bytes = read_text(path);
  return nlohmann::json::parse(bytes.substr(20, load<std::uint32_t>(bytes.data() + 12)));
}

class Growth : public CommandTest {
 protected:
  std::size_t count(const std::string& extension) const {
    std::size_t n = 0;
    for (const auto& entry : std::filesystem::directory_iterator(file("f"))) {
      n += entry.path().extension() == extension ? 1 : 0;
    }
    return n;
  }
  /// A program of that name that is found before any other.
  void fake(const std::string& name, const std::string& script) {
    std::filesystem::create_directory(folder_ / "bin");
    std::ofstream(folder_ / "bin" / name) << "#!/bin/sh\n" << script;
    std::filesystem::permissions(folder_ / "bin" / name, std::filesystem::perms::owner_all);
    path_ = std::getenv("PATH");
    setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
  }
  ~Growth() override {
    if (!path_.empty()) setenv("PATH", path_.c_str(), 1);
  }
  std::string path_;
};

TEST_F(Growth, AnAnimatedGlbPlaysInStagesAndRestsOpen) {
  const CommandResult result =
      run(mud + gaps + std::vector<std::string>{"-o", "a.glb", "--animate", "--stages", "6"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto glb = glb_json(file("a.glb"));
  EXPECT_EQ(glb["meshes"][0]["weights"], std::vector<int>(6, 0));
  for (const auto& primitive : glb["meshes"][0]["primitives"]) {
    EXPECT_EQ(primitive["targets"].size(), 6u);
  }
  EXPECT_EQ(glb["animations"][0]["channels"][0]["target"]["path"], "weights");
  // Readers that know no animation see what is written without.
  ASSERT_EQ(run(mud + gaps + std::vector<std::string>{"-o", "b.glb"}).code, 0);
  EXPECT_EQ(read_mesh_file(file("a.glb")).mesh.positions,
            read_mesh_file(file("b.glb")).mesh.positions);
}

TEST_F(Growth, FramesAsMeshesHaveOneTopologyAndOpenMoreAndMore) {
  const CommandResult result =
      run(mud + gaps +
          std::vector<std::string>{"-o", "a.ply", "--frames", "f", "--frame-count", "5",
                                   "--frame-format", "ply"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(count(".ply"), 5u);
  const SurfaceMesh whole = read_mesh_file(file("a.ply")).mesh;
  double before = -1;
  for (int i = 0; i < 5; ++i) {
    const SurfaceMesh frame = read_mesh_file(file("f/frame_000" + std::to_string(i) + ".ply")).mesh;
    EXPECT_EQ(frame.triangles, whole.triangles);
    const Attribute* openness = find_attribute(frame.vertex_attributes, "openness");
    ASSERT_TRUE(openness);
    double sum = 0;
    for (const double open : openness->values) sum += open;
    EXPECT_GT(sum, before);
    before = sum;
    EXPECT_EQ(sum > 0, i > 0);
    EXPECT_EQ(frame.positions.size(), whole.positions.size());
  }
}

TEST_F(Growth, FramesArePicturesIfNothingElseIsAskedFor) {
  const CommandResult result =
      run(mud + small + std::vector<std::string>{"--frames", "f", "--frame-count", "2"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(count(".png"), 2u);
}

TEST_F(Growth, FragmentsBecomeObjectsAroundTheirOwnMiddle) {
  ASSERT_EQ(
      run(mud + std::vector<std::string>{"-o", "a.glb", "--fragments", "--report", "r.json"}).code,
      0);
  const auto glb = glb_json(file("a.glb"));
  const auto report = nlohmann::json::parse(read_text(file("r.json")));
  ASSERT_GT(report["cracks"]["fragments"], 3);
  EXPECT_EQ(glb["nodes"].size(), report["cracks"]["fragments"]);
  EXPECT_EQ(glb["nodes"][2]["name"], "fragment_2");
  for (const auto& node : glb["nodes"]) {
    // The origin lies within the box of the piece.
    const auto& mesh = glb["meshes"][node["mesh"].get<std::size_t>()];
    const auto& box =
        glb["accessors"][mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
    for (int k = 0; k < 2; ++k) {
      EXPECT_LT(box["min"][k], 0);
      EXPECT_GT(box["max"][k], 0);
    }
  }
  ASSERT_EQ(run(mud + std::vector<std::string>{"-o", "a.obj", "--fragments"}).code, 0);
  const std::string obj = read_text(file("a.obj"));
  EXPECT_NE(obj.find("\no fragment_2\n"), std::string::npos);
  EXPECT_EQ(read_mesh_file(file("a.obj")).mesh.triangles.size(),
            read_mesh_file(file("a.glb")).mesh.triangles.size());
}

TEST_F(Growth, TheVideoIsMadeByFfmpegFromTheFrames) {
  // Keeps what it is asked and given.
  fake("ffmpeg", "echo \"$@\" > asked\nfor last; do true; done\ncat > \"$last\"\n");
  const CommandResult result =
      run(mud + small +
          std::vector<std::string>{"--video", "v.mp4", "--frame-count", "3", "--seconds", "1.5"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(std::filesystem::file_size(file("v.mp4")), 3u * 3 * 160 * 120);
  const std::string asked = read_text(file("asked"));
  EXPECT_NE(asked.find("-video_size 160x120"), std::string::npos) << asked;
  EXPECT_NE(asked.find("-framerate 2"), std::string::npos) << asked;
}

TEST_F(Growth, WhatFfmpegSaysIsPassedOnAndNothingIsLeft) {
  fake("ffmpeg", "echo 'no such codec' >&2\ncat > /dev/null\nexit 3\n");
  expect_error(mud + small + std::vector<std::string>{"--video", "v.mp4", "--frame-count", "1"}, 1,
               "no such codec");
}

TEST_F(Growth, WithoutFfmpegTheErrorComesFirstAndSaysWhatToDo) {
  path_ = std::getenv("PATH");
  setenv("PATH", folder_.path().c_str(), 1);
  expect_error({"crack", "missing.obj", "--video", "v.mp4"}, 1, "ffmpeg is not installed");
}

TEST_F(Growth, ImpossibleRequestsAreSaidBeforeTheInputIsRead) {
  const std::vector<std::string> missing{"crack", "missing.obj"};
  using Words = std::vector<std::string>;
  expect_error(missing + Words{"-o", "a.stl", "--fragments"}, 2, ".obj, .glb and .usda");
  expect_error(missing + Words{"-o", "a.ply", "--fragments"}, 2, "as fragment");
  expect_error(missing + Words{"--fragments", "--report", "r.json"}, 2, "-o FILE");
  expect_error(missing + Words{"-o", "a.obj", "--animate", "--set", "post.gap=0.1"}, 2, ".glb");
  expect_error(missing + Words{"-o", "a.glb", "--animate"}, 2, "post.gap");
  expect_error(missing + Words{"--frames", "f", "--frame-format", "gif"}, 2, "png, ply");
  expect_error(missing + Words{"--video", "v.avi"}, 2, ".mp4");
}

TEST_F(Growth, LinesOfACurvedSurfaceHaveNoDrawingWithoutUvs) {
  std::ofstream(file("tent.obj")) << "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nv 0.5 0.5 0.9\n"
                                     "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  const CommandResult result = run({"crack", "tent.obj", "--lines", "a.svg", "--preset", "mud"});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.err.find("flat surface or UVs"), std::string::npos) << result.err;
}

TEST_F(Growth, AnOpeningThatHasNoRoomIsWarnedOf) {
  const std::vector<std::string> wide =
      mud + std::vector<std::string>{"--set", "post.gap=50", "--set",    "post.wall=0.02",
                                     "-o",    "a.ply",       "--report", "r.json"};
  const CommandResult result = run(wide);
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err.rfind("craze: warning: post.gap", 0), 0u) << result.err;
  const auto report = nlohmann::json::parse(read_text(file("r.json")));
  ASSERT_EQ(report["warnings"].size(), 1u);
  EXPECT_EQ(run(wide + std::vector<std::string>{"--no-warnings"}).err, "");
  EXPECT_EQ(run(wide + std::vector<std::string>{"--quiet"}).err, result.err);
  ASSERT_EQ(run(mud + gaps + std::vector<std::string>{"--report", "r.json"}).code, 0);
  EXPECT_TRUE(nlohmann::json::parse(read_text(file("r.json")))["warnings"].empty());
}

TEST_F(Growth, KeysThatDoNothingForLackOfOthersAreNamed) {
  const auto said = [&](const std::vector<std::string>& keys) {
    std::vector<std::string> arguments = mud;
    for (const std::string& key : keys) arguments.insert(arguments.end(), {"--set", key});
    arguments.insert(arguments.end(), {"--set", "post.relative_roughness=0", "-o", "a.ply"});
    return run(arguments).err;
  };
  EXPECT_EQ(said({"post.wedge=0.5", "post.core=true"}),
            "craze: warning: there are no solid pieces (post.wedge, post.core): give "
            "post.thickness\n");
  EXPECT_EQ(said({"post.roughness_step=0.1"}),
            "craze: warning: lines are not rough (post.roughness_step): give post.roughness or "
            "post.relative_roughness\n");
  EXPECT_EQ(said({"post.chip_size=0.1"}),
            "craze: warning: nothing is chipped (post.chip_size): give post.chipping\n");
  EXPECT_EQ(said({"post.curl=1"}),
            "craze: warning: the cracks are shut and no rims curl (post.curl): maps show it; for a "
            "mesh give post.gap or post.gap_width\n");
  EXPECT_EQ(said({"post.curl=1", "post.gap=0.02"}), "");
}

TEST_F(Growth, AnOpeningIsNotSpokenOfWhereMapsAloneAreAskedFor) {
  const std::vector<std::string> maps =
      mud + std::vector<std::string>{"--set", "post.chipping=0.5", "--maps", "m", "--map",
                                     "mask",  "--map-size",        "64"};
  const CommandResult alone = run(maps);
  EXPECT_EQ(alone.code, 0);
  EXPECT_EQ(alone.err, "");
  const CommandResult both = run(maps + std::vector<std::string>{"-o", "a.ply"});
  EXPECT_NE(both.err.find("no rims to chip"), std::string::npos) << both.err;
}

}  // namespace
}  // namespace craze
