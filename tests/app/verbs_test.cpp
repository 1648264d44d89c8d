#include <cmath>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "craze/base/version.h"
#include "craze/presets.h"

namespace craze {
namespace {

class Verbs : public CommandTest {};

TEST_F(Verbs, HelpIsGivenWithExamplesOnStandardOutput) {
  for (const char* verb : {"crack", "render", "stats", "check", "presets", "parameters"}) {
    const CommandResult result = run({verb, "--help"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    if (std::string(verb) != "parameters") {
      EXPECT_NE(result.out.find(std::string("\n  craze ") + verb), std::string::npos) << verb;
    }
  }
  EXPECT_EQ(run({"--version"}).out, "craze " + version() + "\n");
}

TEST_F(Verbs, PresetsAreListedAndPrinted) {
  const std::string list = run({"presets"}).out;
  for (const Preset& preset : presets()) {
    EXPECT_NE(list.find(preset.name), std::string::npos);
    EXPECT_EQ(run({"presets", std::string(preset.name)}).out, preset.text);
  }
}

TEST_F(Verbs, ParametersAreListedAsTextAndJson) {
  EXPECT_NE(run({"parameters"}).out.find("toughness = 1.0"), std::string::npos);
  EXPECT_GT(nlohmann::json::parse(run({"parameters", "--json"}).out).size(), 30u);
}

TEST_F(Verbs, CheckSaysWhatRepairWouldDo) {
  std::ofstream(file("a.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\nf 1 1 2\n";
  const CommandResult text = run({"check", "a.obj"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("flipped 1"), std::string::npos) << text.out;
  const auto json = nlohmann::json::parse(run({"check", "a.obj", "--json"}).out);
  EXPECT_EQ(json["repair"]["flipped_faces"], 1);
  EXPECT_EQ(json["repair"]["degenerate_faces"], 1);
  EXPECT_EQ(json["repaired"]["triangles"], 2);
  EXPECT_EQ(json["sound"], false);
}

TEST_F(Verbs, CheckSaysWhereAMeshAndItsPartsAre) {
  std::ofstream(file("two.obj")) << "v 1 2 3\nv 2 2 3\nv 1 4 3\nf 1 2 3\n"
                                    "v 11 2 3\nv 12 2 3\nv 11 4 8\nv 12 4 8\nf 4 5 6\nf 5 7 6\n";
  const CommandResult text = run({"check", "two.obj"});
  EXPECT_NE(text.out.find("box (1, 2, 3) to (12, 4, 8), size 11 x 2 x 5\n"), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("part 1: 2 triangles, box (11, 2, 3) to (12, 4, 8)"), std::string::npos)
      << text.out;
  const auto mesh = nlohmann::json::parse(run({"check", "two.obj", "--json"}).out)["repaired"];
  EXPECT_EQ(mesh["box"]["low"], (nlohmann::json{1.0, 2.0, 3.0}));
  EXPECT_EQ(mesh["box"]["size"], (nlohmann::json{11.0, 2.0, 5.0}));
  ASSERT_EQ(mesh["parts"].size(), 2u);
  EXPECT_EQ(mesh["parts"][0]["triangles"], 1);
  EXPECT_EQ(mesh["parts"][0]["box"]["high"], (nlohmann::json{2.0, 4.0, 3.0}));
}

TEST_F(Verbs, CheckListsWhatARecipeCanName) {
  std::ofstream(file("two.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\no door\nusemtl glass\n"
                                    "f 1 2 3\no roof\nusemtl wood\nf 3 2 4\n";
  const std::string text = run({"check", "two.obj"}).out;
  for (const char* line : {"unit: not known", "materials: glass (1), wood (1) triangles\n",
                           "nodes: door (1), roof (1) triangles\n", "UV sets: 0\n",
                           "a spacing to begin with: 0.085\n", "--set layer.spacing=0.085\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
  const auto json = nlohmann::json::parse(run({"check", "two.obj", "--json"}).out);
  EXPECT_EQ(json["materials"][0]["name"], "glass");
  EXPECT_EQ(json["nodes"][1]["triangles"], 1);
  EXPECT_TRUE(json["metres_per_unit"].is_null());
  EXPECT_EQ(json["suggested_spacing"], 0.085);
}

TEST_F(Verbs, JsonIsUtf8WhateverNamesTheInputHas) {
  std::ofstream(file("latin.ply"))
      << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nproperty float caf\xe9\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n";
  EXPECT_TRUE(nlohmann::json::accept(run({"check", "latin.ply", "--json"}).out));
  ASSERT_EQ(run({"crack", "latin.ply", "-o", "a.obj", "--report", "r.json"}).code, 0);
  const auto report = nlohmann::json::parse(read_text(file("r.json")));
  EXPECT_NE(report["warnings"].dump().find("vertex attribute 'caf"), std::string::npos);
}

TEST_F(Verbs, CheckShowsLengthsOfAFileWithAUnitInThatUnit) {
  ASSERT_EQ(run({"crack", "shape:plate?n=4", "-o", "plate.glb", "--max-cracks", "0"}).code, 0);
  const std::string text = run({"check", "plate.glb"}).out;
  EXPECT_NE(text.find("unit: 1 m; size 1m x 1m x 0"), std::string::npos) << text;
  EXPECT_NE(text.find("--set layer.spacing=85mm"), std::string::npos) << text;
}

TEST_F(Verbs, CheckAndRenderSayWhatOfAFileWasNotRead) {
  std::ofstream(file("curve.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ncstype bezier\n";
  const std::string warning = "craze: warning: ";
  EXPECT_EQ(run({"check", "curve.obj"}).err.find(warning), 0u);
  EXPECT_EQ(
      run({"render", "curve.obj", "-o", "a.png", "--width", "8", "--height", "8", "--samples", "1"})
          .err.find(warning),
      0u);
}

TEST_F(Verbs, StatsTakesTheStepsOfPixelsOutOfASkeleton) {
  // A tilted grid of squares, 30 pixels wide, as a skeleton: from pixel to pixel.
  nlohmann::json lines{{"points", nlohmann::json::array()}, {"edges", nlohmann::json::array()}};
  const auto add = [&](double u, double v) {
    const double c = std::cos(0.35), s = std::sin(0.35);
    lines["points"].push_back({std::round(c * u - s * v), std::round(s * u + c * v), 0});
    return lines["points"].size() - 1;
  };
  constexpr int cells = 8, width = 30;
  for (int line = 0; line <= cells; ++line) {
    for (const bool across : {false, true}) {
      std::size_t last = 0;
      for (int t = 0; t <= cells * width; ++t) {
        const std::size_t next = across ? add(line * width, t) : add(t, line * width);
        if (t > 0 && lines["points"][next] != lines["points"][last]) {
          lines["edges"].push_back({last, next});
        }
        last = next;
      }
    }
  }
  std::ofstream(file("skeleton.json")) << lines;
  const auto tortuosity = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"stats", "skeleton.json", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const CommandResult result = run(arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    return nlohmann::json::parse(result.out)["edges"]["tortuosity"]["value"].get<double>();
  };
  EXPECT_GT(tortuosity({}), 1.07);
  EXPECT_NEAR(tortuosity({"--simplify", "1"}), 1, 0.005);
  for (const char* wrong : {"-1", "nan", "wide"}) {
    const CommandResult result = run({"stats", "skeleton.json", "--simplify", wrong});
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find(std::string("--simplify: ") + wrong + " is "), std::string::npos)
        << result.err;
  }
}

TEST_F(Verbs, RenderTakesAPictureOfTheSizeAskedFor) {
  const CommandResult result = run({"render", "shape:sphere", "-o", "a.png", "--width", "40",
                                    "--height", "30", "--samples", "1"});
  EXPECT_EQ(result.code, 0) << result.err;
  const std::string png = read_text(file("a.png"));
  ASSERT_GT(png.size(), 24u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png[19], 40);
  EXPECT_EQ(png[23], 30);
}

TEST_F(Verbs, CrackAndRenderTakeTheSamePictureOptions) {
  const std::vector<std::string> options{"--width",    "32",          "--height",
                                         "24",         "--samples",   "1",
                                         "--up",       "z",           "--azimuth",
                                         "30",         "--elevation", "40",
                                         "--fov",      "30",          "--zoom",
                                         "1.5",        "--material",  "mud",
                                         "--light",    "-40",         "--line-width",
                                         "0.01",       "--no-ground", "--background",
                                         "406080",     "--plain",     "--light-elevation",
                                         "30",         "--exposure",  "1.2",
                                         "--aperture", "0.05",        "--focus",
                                         "1",          "0",           "0"};
  std::vector<std::string> render{"render", "shape:sphere", "-o", "a.png"};
  render.insert(render.end(), options.begin(), options.end());
  EXPECT_EQ(run(render).err, "");
  std::vector<std::string> crack{"crack", "shape:sphere",      "--picture",
                                 "b.png", "--max-cracks",      "0",
                                 "--set", "mesh.edge=\"keep\""};
  crack.insert(crack.end(), options.begin(), options.end());
  EXPECT_EQ(run(crack).err, "");
  EXPECT_EQ(read_text(file("a.png")), read_text(file("b.png")));
  const CommandResult wrong =
      run({"crack", "shape:sphere", "--picture", "a.png", "--background", "blue"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.err.find("six hexadecimal digits"), std::string::npos) << wrong.err;
}

TEST_F(Verbs, LengthsOfOptionsTakeUnits) {
  const std::vector<std::string> small{"--width", "90", "--height", "60", "--samples", "1"};
  const auto with = [&](std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), small.begin(), small.end());
    const CommandResult result = run(words);
    EXPECT_EQ(result.code, 0) << result.err;
    return read_text(file("p.png"));
  };
  const std::vector<std::string> crack{"crack",     "shape:plate?n=6",
                                       "--preset",  "mud",
                                       "--set",     "layer.relative_spacing=0.3",
                                       "--set",     "mesh.edge=keep",
                                       "--set",     "mesh.unit=cm",
                                       "--picture", "p.png",
                                       "-o",        "a.ply"};
  const std::string wide = with(crack, {"--line-width", "0.03"});
  EXPECT_EQ(with(crack, {"--line-width", "0.3mm"}), wide);
  EXPECT_NE(with(crack, {"--line-width", "0.2mm"}), wide);
  const std::vector<std::string> glb{
      "crack", "shape:plate?n=6", "--set", "mesh.unit=cm", "--max-cracks", "0", "-o", "a.glb"};
  for (const std::vector<std::string>& as :
       {std::vector<std::string>{}, {"--as", "maps", "--map-size", "16"}}) {
    std::vector<std::string> words = glb;
    words.insert(words.end(), as.begin(), as.end());
    const CommandResult result = run(words);
    EXPECT_NE(result.err.find("0.01 m, is 1 m in the .glb"), std::string::npos) << result.err;
  }
  const std::vector<std::string> render{"render", "a.ply", "-o", "p.png"};
  const double diagonal = std::sqrt(2.0);
  EXPECT_EQ(with(render, {"--line-width", "3%"}),
            with(render, {"--line-width", nlohmann::json(3 * diagonal / 100).dump()}));

  const std::string coarse = run({"stats", "a.ply", "--json", "--simplify", "4%"}).out;
  EXPECT_EQ(
      run({"stats", "a.ply", "--json", "--simplify", nlohmann::json(4 * diagonal / 100).dump()})
          .out,
      coarse);
  EXPECT_NE(run({"stats", "a.ply", "--json"}).out, coarse);
  EXPECT_NE(run({"stats", "a.ply", "--simplify", "4mm"}).err.find("(--simplify)"),
            std::string::npos);
  EXPECT_EQ(run({"stats", "a.ply", "--simplify", "4 mm"}).code, 2);
}

TEST_F(Verbs, AllThatReadAMeshSayWhatTheyLeaveOutUnlessToldNotTo) {
  // Two triangles parted along an edge; a mesh keeps no points.
  std::ofstream(file("a.obj"))
      << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\np 1\n";
  const std::vector<std::vector<std::string>> verbs{
      {"check", "a.obj"},
      {"stats", "a.obj"},
      {"render", "a.obj", "-o", "a.png", "--width", "8", "--height", "8", "--quiet"},
      {"crack", "a.obj", "-o", "a.ply", "--max-cracks", "0", "--quiet"}};
  for (std::vector<std::string> verb : verbs) {
    const CommandResult said = run(verb);
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_EQ(said.err.rfind("craze: warning: ", 0), 0u) << verb[0] << ": " << said.err;
    verb.emplace_back("--no-warnings");
    EXPECT_EQ(run(verb).err, "") << verb[0];
  }
}

}  // namespace
}  // namespace craze
