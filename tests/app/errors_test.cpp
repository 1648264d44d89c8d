#include "app/command.h"
#include "craze/render/png.h"

namespace craze {
namespace {

class Errors : public CommandTest {};

TEST_F(Errors, WrongUsageExitsWithTwo) {
  expect_error({}, 2, "craze --help");
  expect_error({"crakc"}, 2, "did you mean crack?");
  expect_error({"crack", "shape:plate", "--presett", "mud"}, 2, "did you mean --preset?");
  expect_error({"crack", "shape:plate", "--ouput=a.ply"}, 2, "did you mean --output?");
  expect_error({"dataset", "verify", "set", "--quite"}, 2, "did you mean --quiet?");
  expect_error({"crack"}, 2, "craze crack --help");
  expect_error({"crack", "shape:plate", "--frobnicate"}, 2, "--frobnicate");
  expect_error({"crack", "shape:plate"}, 2, "-o FILE");
  expect_error({"crack", "shape:plate", "-o", "a.xyz"}, 2, ".glb");
  expect_error({"crack", "shape:plate", "--lines", "a.png"}, 2, ".svg");
  expect_error({"crack", "shape:plat", "-o", "a.ply"}, 2, "plate");
  expect_error({"crack", "shape:plate", "-o", "a.ply", "--preset", "glase"}, 2, "glaze");
  expect_error({"crack", "shape:plate", "-o", "a.ply", "--set", "material.tougness=1"}, 2,
               "did you mean material.toughness?");
  expect_error({"crack", "shape:plate", "-o", "a.ply", "--set", "material.alpha=2"}, 2, "[0, 1]");
  expect_error({"crack", "shape:plate", "-o", "a.ply", "--seed", "-1"}, 2, "seed");
  expect_error({"crack", "shape:plate", "-o", "a.ply", "--max-cracks", "-1"}, 2, "--max-cracks");
  expect_error({"crack", "shape:plate", "-o", "a.ply", "--lines", "./a.ply"}, 2, "same file");
  expect_error({"crack", "shape:plate", "-o", "a.ply", "--preset", "mud", "--recipe", "x.toml"}, 2,
               "--preset");
  expect_error({"render", "shape:cup", "-o", "a.png", "--background", "blue"}, 2, "606a78");
  expect_error({"render", "shape:cup", "-o", "a.png", "--material", "marble"}, 2, "plaster");
  expect_error({"render", "shape:cup", "-o", "a.png", "--zoom", "0"}, 2, "--zoom");
  for (const char* option : {"--azimuth", "--elevation", "--fov", "--zoom", "--aperture", "--light",
                             "--exposure", "--line-width"}) {
    expect_error({"render", "shape:cup", "-o", "a.png", option, "nan"}, 2, option);
    expect_error({"render", "shape:cup", "-o", "a.png", option, "wide"}, 2, "not a number");
  }
  for (const char* option : {"--width", "--height"}) {
    expect_error({"render", "shape:cup", "-o", "a.png", option, "0"}, 2, option);
    expect_error({"render", "shape:cup", "-o", "a.png", option, "16385"}, 2, option);
  }
}

TEST_F(Errors, AFailedRunExitsWithOne) {
  expect_error({"crack", "missing.obj", "-o", "a.ply"}, 1, "missing.obj");
  expect_error({"crack", "shape:plate", "-o", "missing/a.ply"}, 1, "folder does not exist");
  expect_error({"crack", "shape:plate", "-o", "a.ply", "--recipe", "missing.toml"}, 1,
               "missing.toml");
  expect_error({"crack", "shape:plate?n=3", "-o", "a.ply", "--set", "stress.attribute=paint"}, 1,
               "paint");
  expect_error({"check", "missing.stl"}, 1, "missing.stl");
}

TEST_F(Errors, AnImpactFarFromTheSurfaceIsRefusedWithTheNearestPoint) {
  expect_error({"crack", "shape:plate?n=4", "-o", "a.ply", "--set", "impact.0.point=[0,0,3]"}, 1,
               "3 away from the surface");
}

TEST_F(Errors, APictureNeedsTextureCoordinates) {
  std::ofstream(folder_ / "bare.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  render::write_png((folder_ / "grey.png").string(), {1, 1, {9, 9, 9}});
  for (const char* section : {"stress", "material", "layer"}) {
    expect_error({"crack", "../bare.obj", "-o", "a.ply", "--set",
                  std::string(section) + ".texture=\"../grey.png\""},
                 1, std::string("(") + section + ".texture): the input has no texture coordinates");
  }
}

TEST_F(Errors, AMissingAttributeIsMetWithThoseThereAre) {
  std::ofstream(folder_ / "painted.ply")
      << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nproperty float rust\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n"
         "0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n";
  for (const char* key :
       {"stress.attribute", "material.attribute", "layer.attribute", "boundary.fixed_attribute"}) {
    expect_error({"crack", "../painted.ply", "-o", "a.ply", "--set", std::string(key) + "=paint"},
                 1, "per vertex it has rust");
  }
}

TEST_F(Errors, ASpacingThatMemoryIsTooSmallForIsRefusedWithAnEstimate) {
  expect_error({"crack", "shape:plate?n=4", "-o", "a.ply", "--set", "layer.spacing=1e-6"}, 1,
               "GB of memory");
  expect_error({"crack", "shape:plate?n=4", "-o", "a.ply", "--set", "mesh.edge=1e-7"}, 1,
               "edge too short for this machine (mesh.edge)");
}

TEST_F(Errors, ASpacingLargerThanTheObjectIsRefused) {
  expect_error({"crack", "shape:plate?n=4", "-o", "a.ply", "--set", "layer.spacing=2"}, 1,
               "spacing larger than the object (layer.spacing)");
  expect_error({"crack", "shape:plate?n=4", "-o", "a.ply", "--set", "layer.relative_spacing=1.1"},
               1, "spacing larger than the object");
}

TEST_F(Errors, ZeroStressEverywhereIsEquilibriumAndIsSaid) {
  const CommandResult result =
      run({"crack", "shape:plate?n=4", "-o", "a.ply", "--set", "stress.uniform=0"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err,
            "craze: warning: nothing can crack (stress): it is zero everywhere; give "
            "stress.uniform, an impact or a painted stress that is not\n");
}

TEST_F(Errors, TooLittleStressForACrackIsSaid) {
  const std::vector<std::string> crack{"crack", "shape:plate?n=4", "-o", "a.ply"};
  std::vector<std::string> bare = crack, few = crack, preset = crack;
  bare.insert(bare.end(), {"--set", "stress.uniform=0.01"});
  EXPECT_EQ(run(bare).err,
            "craze: warning: no crack opened (stress): the surface holds; start from a preset, or "
            "give more stress, more evolution.max_load, or less layer.spacing than parts are "
            "large\n");
  std::vector<std::string> closed = crack;
  closed.insert(closed.end(), {"--preset", "mud", "--set", "where.materials=none"});
  EXPECT_EQ(run(closed).err.find("no crack opened"), std::string::npos);
  few.insert(few.end(), {"--set", "stress.uniform=0.01", "--max-cracks", "0"});
  EXPECT_EQ(run(few).err, "");
  preset.insert(preset.end(), {"--preset", "mud", "--set", "layer.spacing=0.2"});
  EXPECT_EQ(run(preset).err.find("no crack opened"), std::string::npos);
}

TEST_F(Errors, OptionsThatWouldDoNothingAreRefused) {
  using Words = std::vector<std::string>;
  const std::string picture = "--picture, --frames (.png) or --video";
  const std::vector<std::pair<Words, std::string>> alone{
      {{"--width", "300"}, picture},
      {{"--samples", "1"}, picture},
      {{"--at", "0", "0", "1"}, picture},
      {{"--aperture", "0.1"}, picture},
      {{"--plain"}, picture},
      {{"--line-width", "0.1"}, picture},
      {{"--light", "20"}, picture},
      {{"--environment", "sky.hdr"}, picture},
      {{"--no-ground"}, picture},
      {{"--background", "ffffff"}, picture},
      {{"--frames", "f", "--frame-format", "ply", "--width", "300"}, picture},
      {{"--picture", "p.png", "--focus", "0", "0", "1"}, "--aperture"},
      {{"--map", "height"}, "--maps"},
      {{"--map-green", "down"}, "--maps"},
      {{"--as", "maps", "--map-format", "exr"}, "--maps"},
      {{"--maps", "m", "--map", "mask", "--map-green", "down"}, "--map normal or --map direction"},
      {{"--map-size", "64"}, "--maps or --as maps"},
      {{"--maps", "m", "--stain", "3b2314"}, "--as maps"},
      {{"--stages", "8"}, "--animate"},
      {{"--seconds", "2"}, "--animate or --video"},
      {{"--frame-count", "8"}, "--frames or --video"},
      {{"--frame-format", "png"}, "--frames"}};
  for (const auto& [words, needed] : alone) {
    Words arguments{"crack", "missing.obj", "-o", "a.glb"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    expect_error(arguments, 2, "give " + needed + " too, or leave it out");
  }
  expect_error({"render", "missing.obj", "-o", "a.png", "--focus", "0", "0", "1"}, 2, "--aperture");
  for (const char* verb : {"bake", "texture"}) {
    const std::string input = std::string(verb) == "bake" ? "missing.ply" : "mud";
    const Words height{verb, input, "-o", "m", "--map", "height", "--map-green", "down"};
    expect_error(height, 2, "--map normal or --map direction");
  }
  // Which say something of files, or of the recipe in the report.
  EXPECT_EQ(run({"crack", "shape:plate?n=4", "-o", "a.glb", "--up", "y", "--material", "mud",
                 "--max-cracks", "0"})
                .code,
            0);
}

TEST_F(Errors, OptionsOfMakingASetSayNothingToItsVerbs) {
  for (const char* making : {"plan.toml", "--samples=3", "--shard=0/2", "--output=x", "--keys"}) {
    expect_error({"dataset", making, "verify", "set"}, 2, "verify");
  }
  expect_error({"dataset", "--keys", "--samples", "3"}, 2, "--keys");
  expect_error({"sweep", "--keys", "--shard", "0/2"}, 2, "--keys");
}

TEST_F(Errors, WrongOutputsAreFoundBeforeTheInputIsRead) {
  expect_error({"crack", "missing.obj", "-o", "a.xyz"}, 2, "a.xyz");
  expect_error({"crack", "missing.obj", "--report", "missing/r.json"}, 1, "missing/r.json");
}

TEST_F(Errors, ARecipeErrorNamesFileAndLine) {
  std::ofstream(folder_ / "bad.toml") << "seed = 1\n[material]\nalfa = 0.5\n";
  expect_error({"crack", "shape:plate", "-o", "a.ply", "--recipe", "../bad.toml"}, 2,
               "../bad.toml:3:8");
}

TEST_F(Errors, AFailureLeavesAnOlderOutputAlone) {
  std::ofstream(file("a.ply")) << "older";
  std::ofstream(file("broken.obj")) << "v 0 0 0\nf 1 2 3\n";
  EXPECT_EQ(run({"crack", "broken.obj", "-o", "a.ply"}).code, 1);
  EXPECT_EQ(read_text(file("a.ply")), "older");
}

TEST_F(Errors, ControlCharactersDoNotReachTheTerminal) {
  const CommandResult result =
      run({"crack", "shape:plate", "-o", "a\x1b[31m\n.ply", "--set", "a=1"});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1);
}

TEST_F(Errors, AFullDiskIsSaid) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  const CommandResult result = finish(start({"parameters"}, "/dev/full"));
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.err.find("standard output"), std::string::npos);
}

TEST_F(Errors, AClosedPipeIsNoNews) {
  const std::string command = std::string("'") + CRAZE_COMMAND + "' parameters --json 2> '" +
                              (folder_ / "err").string() + "'; echo $? > '" +
                              (folder_ / "code").string() + "'";
  // The reader is gone before the command starts to write.
  FILE* pipe = popen(("(sleep 0.2; " + command + ") | true").c_str(), "r");
  pclose(pipe);
  EXPECT_EQ(read_text(folder_ / "err"), "");
  EXPECT_EQ(read_text(folder_ / "code"), "1\n");
}

}  // namespace
}  // namespace craze
