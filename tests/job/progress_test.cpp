// What long calls say of how far they are.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "craze/context.h"
#include "craze/job/dataset/dataset.h"
#include "craze/job/dataset/verify_dataset.h"
#include "craze/job/run.h"
#include "craze/job/sweep/sweep.h"
#include "craze/job/texture.h"
#include "craze/presets.h"
#include "temporary_folder.h"

namespace craze {
namespace {

namespace fs = std::filesystem;

/// Every report, as it comes.
class Progresses : public ::testing::Test {
 protected:
  Progresses() {
    context_.threads = Threads(2);
    context_.progress = [this](const Progress& p) { hear(p); };
  }

  /// Of the whole call: a phase that told fractions ended with 1, and none fell but to begin anew.
  void expect_whole() {
    end_phase();
    EXPECT_FALSE(phases_.empty());
  }

  std::string at(const std::string& name) const { return (folder_.path() / name).string(); }

  RunRequest request(const std::string& input, const std::string& settings) const {
    RunRequest request;
    request.input = input;
    request.recipe = read_preset("mud");
    apply_set(request.recipe, "layer.relative_spacing=0.3");
    std::istringstream words(settings);
    for (std::string word; words >> word;) apply_set(request.recipe, word);
    request.max_cracks = 40;
    request.shot.width = 60;
    request.shot.height = 40;
    request.shot.samples = 1;
    request.maps.options.size = 64;
    return request;
  }

  Context context_;
  TemporaryFolder folder_;
  std::set<std::string> phases_;

 private:
  void hear(const Progress& p) {
    if (p.phase != phase_) end_phase();
    phase_ = p.phase;
    phases_.insert(phase_);
    if (p.fraction < 0) return;
    EXPECT_LE(p.fraction, 1) << phase_;
    if (last_ < 1) {
      EXPECT_GE(p.fraction, last_) << phase_;
    }
    last_ = p.fraction;
  }

  void end_phase() {
    if (last_ >= 0) {
      EXPECT_EQ(last_, 1) << phase_;
    }
    last_ = -1;
  }

  std::string phase_;
  double last_ = -1;
};

TEST_F(Progresses, OfAllThatARunWritesEndAtOne) {
  RunRequest all =
      request("shape:cube?n=3", "post.gap=0.05 post.wall=0.02 post.face_roughness=0.2");
  all.output = at("a.glb");
  all.animate = true;
  all.lines = at("a.svg");
  all.picture = at("a.png");
  all.frames = at("frames");
  all.frame_count = 3;
  all.maps.folder = at("maps");
  all.fields = at("fields.ply");
  all.report = at("a.json");
  run(all, context_);
  expect_whole();
  for (const char* phase : {"repair", "remesh", "prepare", "carry", "open", "roughen", "animate",
                            "write", "lines", "maps", "picture", "develop", "frames"}) {
    EXPECT_EQ(phases_.count(phase), 1u) << phase;
  }
}

TEST_F(Progresses, OfEveryMeshFormatReadAndWrittenEndAtOne) {
  for (const char* format : {"ply", "obj", "stl", "glb", "usda"}) {
    SCOPED_TRACE(format);
    RunRequest one = request("shape:cube?n=3", "mesh.edge=keep");
    one.output = at(std::string("a.") + format);
    run(one, context_);
    expect_whole();
    if (format == std::string("usda")) continue;  // which is written alone
    RunRequest two = request(one.output, "mesh.edge=keep");
    two.output = at(std::string("b.") + format);
    run(two, context_);
    expect_whole();
  }
  EXPECT_EQ(phases_.count("load"), 1u);
}

TEST_F(Progresses, OfPiecesAndMappedMeshesEndAtOne) {
  RunRequest pieces = request("shape:cube?n=3", "mesh.edge=keep post.thickness=0.05");
  pieces.output = at("a.glb");
  pieces.split_fragments = true;
  run(pieces, context_);
  expect_whole();
  EXPECT_EQ(phases_.count("thicken"), 1u);
  RunRequest mapped = request(at("a.glb"), "mesh.edge=keep");
  mapped.output = at("b.glb");
  mapped.as_maps = true;
  run(mapped, context_);
  expect_whole();
}

TEST_F(Progresses, OfImpactsEndAtOne) {
  RunRequest hit = request("shape:plate?n=9", "mesh.edge=keep");
  hit.recipe.simulation.impacts.emplace_back();
  hit.recipe.simulation.impacts.back().radius = 0.2;
  hit.output = at("a.ply");
  run(hit, context_);
  expect_whole();
  EXPECT_EQ(phases_.count("impacts"), 1u);
}

TEST_F(Progresses, OfTexturesEndAtOne) {
  TextureRequest texture;
  texture.recipe = request("", "layer.relative_spacing=0.15 evolution.max_cracks=40").recipe;
  texture.maps.folder = at("texture");
  texture.maps.options.size = 32;
  texture.previews = false;
  make_texture(texture, context_);
  expect_whole();
}

TEST_F(Progresses, OfSetsAndTheirShardsEndAtOne) {
  const PlanSource plan{
      "samples = 5\nshard_samples = 2\nwidth = 32\nheight = 32\n[object]\nmesh = "
      "\"shape:plate?n=6\"\n[recipe]\npreset = \"mud\"\nmesh.edge = \"keep\"\n"
      "evolution.max_cracks = 30\n[lines]\nwidth = 6\n",
      "plan.toml", folder_.path()};
  for (const std::uint64_t shard : {0, 1}) {
    make_dataset(plan, at("set"), {shard, 2}, context_);
    expect_whole();
  }
  EXPECT_EQ(phases_.count("dataset"), 1u);
  EXPECT_TRUE(verify_dataset(at("set"), context_).empty());
  expect_whole();
}

TEST_F(Progresses, OfSweepsAndTheirShardsEndAtOne) {
  const PlanSource plan{
      "part_rows = 2\nrepeats = 5\nobject = \"shape:plate?n=6\"\n[recipe]\npreset = \"mud\"\n"
      "mesh.edge = \"keep\"\nevolution.max_cracks = 2\n",
      "plan.toml", folder_.path()};
  for (const std::uint64_t shard : {0, 1}) {
    run_sweep(plan, at("sweep"), {shard, 2}, context_);
    expect_whole();
  }
  EXPECT_EQ(phases_.count("sweep"), 1u);
}

}  // namespace
}  // namespace craze
