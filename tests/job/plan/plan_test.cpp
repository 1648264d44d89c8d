#include "craze/job/plan/plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "craze/error.h"
#include "craze/length.h"

namespace craze {
namespace {

PlanSchema schema() {
  PlanSchema s{"test", {}, true};
  s.keys = {
      {.key = "seed",
       .type = PlanKeyType::integer,
       .standard = 1.0,
       .low = 0,
       .high = 1e9,
       .fixed = true},
      {.key = "camera.zoom", .standard = 1.0, .low = 0.1, .high = 10},
      {.key = "camera.tilt", .standard = 0.0, .low = 0, .high = 90},
      {.key = "surface.material",
       .type = PlanKeyType::word,
       .standard = std::string("clay"),
       .choices = {"clay", "mud"}},
      {.key = "marks", .type = PlanKeyType::integer, .standard = 0.0, .low = 0, .high = 9},
  };
  return s;
}

Plan plan(const std::string& text) {
  return Plan(text, "p.toml", schema());
}

std::string refusal(const std::string& text) {
  try {
    plan(text).draw(0);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::usage);
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
    return e.what();
  }
  return "accepted";
}

TEST(Plan, ARunIsAFunctionOfPlanAndIndexAlone) {
  const std::string text = "camera.zoom = {uniform = [1, 2]}\nmarks = {uniform = [0, 5]}\n";
  const Plan a = plan(text), b = plan(text);
  b.draw(5);
  EXPECT_EQ(a.draw(3), b.draw(3));
  EXPECT_NE(a.draw(3), a.draw(4));
  EXPECT_NE(a.draw(3), a.draw(3, 1));
  EXPECT_NE(a.draw(3), plan(text + "seed = 2\n").draw(3));
}

TEST(Plan, AnotherKeyChangesNoneOfTheOthers) {
  const Plan few = plan("camera.zoom = {uniform = [1, 2]}");
  const Plan more = plan(
      "camera.tilt = {uniform = [0, 9]}\ncamera.zoom = {uniform = [1, 2]}\n"
      "[recipe.stress]\nnoise = {uniform = [0, 1]}");
  for (std::uint64_t i = 0; i < 20; ++i) {
    EXPECT_EQ(few.draw(i).at("camera.zoom"), more.draw(i).at("camera.zoom"));
  }
}

TEST(Plan, DrawsFollowTheirLaws) {
  const Plan p = plan(
      "[camera]\nzoom = {log_uniform = [0.1, 10]}\ntilt = {normal = [45, 10], within = [30, 90]}\n"
      "[surface]\nmaterial = {choice = [\"clay\", \"mud\"], weights = [3, 1]}");
  double log = 0, tilt = 0, clay = 0;
  constexpr int n = 4000;
  for (std::uint64_t i = 0; i < n; ++i) {
    const PlanValues v = p.draw(i);
    const double z = number_of(v, "camera.zoom"), t = number_of(v, "camera.tilt");
    EXPECT_TRUE(z >= 0.1 && z <= 10 && t >= 30 && t <= 90);
    log += std::log10(z) / n;
    tilt += t / n;
    clay += word_of(v, "surface.material") == "clay" ? 1.0 / n : 0;
  }
  EXPECT_NEAR(log, 0, 4 * 0.577 / std::sqrt(n));
  // Mean of the truncated law: 45 + 10 φ(1.5) / Φ(1.5).
  EXPECT_NEAR(tilt, 46.388, 4 * 9 / std::sqrt(n));
  EXPECT_NEAR(clay, 0.75, 4 * 0.433 / std::sqrt(n));
}

TEST(Plan, LinkedKeysGoWithTheOther) {
  const Plan p = plan(
      "[camera]\ntilt = {linked = \"camera.zoom\", factor = 2, offset = 1}\n"
      "zoom = {linked = \"surface.material\", map = {clay = 3, mud = 4}}\n"
      "[surface]\nmaterial = {choice = [\"clay\", \"mud\"]}");
  for (std::uint64_t i = 0; i < 20; ++i) {
    const PlanValues v = p.draw(i);
    const double zoom = word_of(v, "surface.material") == "clay" ? 3 : 4;
    EXPECT_EQ(number_of(v, "camera.zoom"), zoom);
    EXPECT_EQ(number_of(v, "camera.tilt"), 2 * zoom + 1);
  }
}

TEST(Plan, LinksAreRefusedForValuesThatAreNotDrawnYetToo) {
  const std::string tilt = "camera.tilt = {choice = [1, 60], weights = [1e9, 1]}\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"camera.zoom = {linked = \"camera.tilt\"}", "must be in [0.1, 10]"},
      {"camera.zoom = {linked = \"camera.tilt\", map = {1 = 1}}", "no value for camera.tilt = 60"},
      {"recipe.material.alpha = {linked = \"camera.tilt\"}", "material.alpha = 60"},
      {"recipe.material.alpha = {linked = \"surface.material\"}", "wrong type"},
      {"recipe.preset = {linked = \"surface.material\", map = {clay = \"claj\"}}", "claj"}};
  for (const auto& [link, words] : cases) {
    try {
      plan(tilt + link);
      ADD_FAILURE() << link;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
  }
}

TEST(Plan, TheRecipeIsThePresetWithTheKeysDrawn) {
  const Plan p = plan(
      "[recipe]\npreset = \"mud\"\n[recipe.stress]\nuniform = {uniform = [2, 3]}\n"
      "tensor = [1, 0, 0, 0, 0, 0]\n[recipe.layer]\nspacing = {choice = [\"4mm\", \"3%\"]}\n"
      "[recipe.evolution]\nmax_cracks = {uniform = [3, 9]}");
  const Recipe r = recipe_of(p, p.draw(7), 99);
  EXPECT_EQ(r.picture.material, "mud");
  EXPECT_EQ(r.simulation.seed, 99u);
  EXPECT_TRUE(r.simulation.stress.uniform >= 2 && r.simulation.stress.uniform < 3);
  EXPECT_EQ(r.simulation.stress.tensor[0], 1);
  EXPECT_GE(r.simulation.evolution.max_cracks, 3);
  EXPECT_EQ(recipe_of(p, p.draw(7), 99), r);
}

/// The millimetres of a value of a length.
double millimetres(const PlanValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  EXPECT_TRUE(text && text->ends_with("mm")) << plan_text(value);
  return text ? std::stod(*text) : 0;
}

TEST(Plan, LengthsAreDrawnWithTheirUnits) {
  const Plan p = plan(
      "[recipe.layer]\nspacing = {uniform = [\"2mm\", \"0.5cm\"]}\n[recipe.mesh]\nunit = \"cm\"\n"
      "edge = {log_uniform = [\"0.1mm\", \"1mm\"]}\n[recipe.post]\n"
      "gap_width = {normal = [\"1mm\", \"0.2mm\"], within = [0, \"0.2cm\"]}\n"
      "thickness = {linked = \"recipe.layer.spacing\", factor = 2, offset = \"0.1cm\"}\n");
  double sum = 0;
  constexpr int n = 400;
  for (std::uint64_t i = 0; i < n; ++i) {
    const PlanValues v = p.draw(i);
    const double spacing = millimetres(v.at("recipe.layer.spacing"));
    const double edge = millimetres(v.at("recipe.mesh.edge"));
    const double gap = millimetres(v.at("recipe.post.gap_width"));
    EXPECT_TRUE(spacing >= 2 && spacing < 5 && edge >= 0.1 && edge <= 1 && gap >= 0 && gap <= 2);
    EXPECT_DOUBLE_EQ(millimetres(v.at("recipe.post.thickness")), 2 * spacing + 1);
    sum += spacing / n;
  }
  EXPECT_NEAR(sum, 3.5, 4 * 3 / std::sqrt(12.0 * n));
  const Recipe r = recipe_of(p, p.draw(7), 99);
  const Length spacing = r.simulation.layer.spacing;
  EXPECT_EQ(spacing.unit(), LengthUnit::millimetre);
  EXPECT_TRUE(spacing.number() >= 2 && spacing.number() < 5);
  // Percentages too, and what had no unit is drawn as before.
  EXPECT_TRUE(plan_text(plan("recipe.layer.spacing = {uniform = [\"2%\", \"5%\"]}")
                            .draw(0)
                            .at("recipe.layer.spacing"))
                  .ends_with("%"));
}

TEST(Plan, LengthsOfOneLawAreOfOneKind) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"recipe.layer.spacing = {uniform = [\"2mm\", 5]}", "do not convert"},
      {"recipe.layer.spacing = {uniform = [\"2mm\", \"5%\"]}", "do not convert"},
      {"recipe.layer.spacing = {uniform = [\"2cm\", \"5mm\"]}", "the smaller number first"},
      {"recipe.layer.spacing = {uniform = [\"2mm\", \"5 apples\"]}", "such as \"4mm\""},
      {"recipe.layer.spacing = {normal = [\"2mm\", \"1mm\"], within = [1, 2]}", "do not convert"},
      {"recipe.layer.spacing = {linear = [\"2mm\", \"5mm\", \"3mm\"]}", "must be a finite number"},
      {"recipe.layer.spacing = {uniform = [\"-2mm\", \"5mm\"]}", "layer.spacing"},
      {"recipe.stress.noise = {uniform = [\"2mm\", \"5mm\"]}", "stress.noise"},
      {"camera.zoom = {uniform = [\"2mm\", \"5mm\"]}", "must be a number"},
      {"[recipe.layer]\nspacing = {linked = \"recipe.post.gap_width\", offset = \"1%\"}\n"
       "[recipe.post]\ngap_width = {uniform = [\"1mm\", \"2mm\"]}",
       "do not convert"}};
  for (const auto& [text, why] : cases) {
    EXPECT_NE(refusal(text).find(why), std::string::npos) << text << ": " << refusal(text);
    EXPECT_NE(refusal(text).find("p.toml:"), std::string::npos) << refusal(text);
  }
}

TEST(Plan, AxesAreReadAsListsAndAsEvenSteps) {
  const Plan p = plan("camera.zoom = {log = [0.1, 10, 3]}\ncamera.tilt = {linear = [0, 9, 4]}");
  const auto values = [&](std::size_t i) {
    return std::get<Axis>(p.entries()[i].distribution).values;
  };
  ASSERT_EQ(values(1).size(), 3u);
  EXPECT_EQ(std::get<double>(values(1)[0]), 0.1);
  EXPECT_NEAR(std::get<double>(values(1)[1]), 1, 1e-15);
  EXPECT_EQ(std::get<double>(values(2)[1]), 3);
  const Plan lengths = plan("recipe.layer.spacing = {linear = [\"2mm\", \"1cm\", 3]}");
  std::string texts;
  for (const PlanValue& v : std::get<Axis>(lengths.entries().back().distribution).values) {
    texts += plan_text(v) + " ";
  }
  EXPECT_EQ(texts, "2mm 6mm 10mm ");
}

TEST(Plan, HostilePlansAreRefusedInOneLineWithThePlace) {
  EXPECT_EQ(refusal("camera.zom = 1"),
            "unknown key camera.zom (p.toml:1:14): did you mean camera.zoom?");
  const std::vector<std::pair<std::string, std::string>> cases{
      {"camera = 1", "unknown key camera"},
      {"camera = {}", "unknown key camera"},
      {"zoom = ", "not a TOML plan (p.toml:1:"},
      {"{\"camera\": ", "not a JSON plan (p.toml): what is at byte"},
      {"camera.zoom = 11", "must be in [0.1, 10]"},
      {"camera.zoom = {uniform = [1, 11]}", "must be in [0.1, 10]"},
      {"camera.zoom = {uniform = [2, 1]}", "the smaller number first"},
      {"camera.zoom = {uniform = [1]}", "needs 2 numbers"},
      {"camera.zoom = {uniform = [1, inf]}", "finite"},
      {"camera.zoom = {log_uniform = [0, 1]}", "above 0"},
      {"camera.zoom = {normal = [1, -1]}", "below 0"},
      {"camera.zoom = {normal = [1, 1]}", "must be in [0.1, 10]"},
      {"camera.zoom = {unifrom = [1, 2]}", "did you mean uniform?"},
      {"camera.zoom = {uniform = [1, 2], normal = [1, 2]}", "both uniform and normal"},
      {"camera.zoom = {uniform = [1, 2], weights = [1]}", "unknown word weights"},
      {"camera.zoom = {choice = []}", "needs values"},
      {"camera.zoom = {choice = [1, 2], weights = [1]}", "needs 2 numbers"},
      {"camera.zoom = {choice = [1, 2], weights = [0, 0]}", "sum to nothing"},
      {"camera.zoom = {linked = \"camera.tlt\"}", "the plan does not give it"},
      {"camera.zoom = {linked = \"camera.zoom\"}", "circle"},
      {"camera.zoom = {linked = \"camera.tilt\"}\ncamera.tilt = {linked = \"camera.zoom\"}",
       "circle"},
      {"camera.zoom = {linked = \"camera.tilt\", offset = 99}", "must be in [0.1, 10]"},
      {"camera.zoom = {linked = \"surface.material\", map = {mud = 1}}", "the map has none"},
      {"camera.zoom = {linked = \"surface.material\", factor = 2}", "not a number"},
      {"camera.zoom = {linear = [1, 2, 2.5]}", "counts the values"},
      {"camera.zoom = {linear = [1, 2, 1e9]}", "counts the values"},
      {"camera.zoom = \"big\"", "must be a number"},
      {"surface.material = \"mudd\"", "choose one of clay, mud"},
      {"surface.material = 3", "must be text"},
      {"seed = {uniform = [1, 2]}", "one value alone for seed"},
      {"seed = 1.5", "whole number"},
      {"recipe = 3", "must be a section"},
      {"recipe.preset = \"mudd\"", "mud"},
      {"recipe.stress.noise = -1", "stress.noise"},
      {"recipe.stress.noise = {uniform = [-1, 1]}", "stress.noise"},
      {"recipe.stress.nois = 1", "did you mean recipe.stress.noise?"},
      {"[[recipe.impact]]\nradius = 1", "no impacts in a plan"},
      {std::string("camera.zoom = ") + std::string(5000, '['), "not a TOML plan"},
      {"a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.b = 1", "nested too deep"},
  };
  for (const auto& [text, words] : cases) {
    EXPECT_NE(refusal(text).find(words), std::string::npos) << text << ": " << refusal(text);
  }
}

}  // namespace
}  // namespace craze
