#include "craze/recipe.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "craze/recipe/length_text.h"
#include "craze/recipe/parameter_table.h"
#include "craze/recipe/recipe_json.h"
#include "craze/recipe/set_key.h"
#include "error_message.h"

namespace craze {
namespace {

std::string read_error(const std::string& text) {
  return error_of([&] { read_recipe(text, "r.toml"); }, ErrorKind::usage);
}

std::string set_error(const std::string& assignment) {
  Recipe recipe;
  const std::string message = error_of([&] { apply_set(recipe, assignment); }, ErrorKind::usage);
  EXPECT_TRUE(recipe == Recipe{}) << "a refused setting left a trace";
  return message;
}

rc::Gen<double> real_in(const ParameterRange& range) {
  return rc::gen::map(rc::gen::arbitrary<double>(), [range](double x) {
    if (range.contains(x)) return x;
    const double low = std::isfinite(range.low) ? range.low : -1e6;
    const double high = std::isfinite(range.high) ? range.high : 1e6;
    const double t = 0.5 + 0.49 * std::tanh(std::isfinite(x) ? x : 1);
    return low + (high - low) * t;
  });
}

ParameterValue arbitrary_value(const Parameter& p) {
  const auto numbers = [&](std::size_t n) {
    return ParameterValue(*rc::gen::container<std::vector<double>>(n, real_in(p.range)));
  };
  switch (p.type) {
    case ParameterType::real:
      return *real_in(p.range);
    case ParameterType::integer:
      return *rc::gen::inRange<std::int64_t>(
          static_cast<std::int64_t>(p.range.low),
          static_cast<std::int64_t>(std::min(p.range.high, 0x1p53)));
    case ParameterType::boolean:
      return *rc::gen::arbitrary<bool>();
    case ParameterType::choice:
      return *rc::gen::elementOf(p.choices);
    case ParameterType::string:
      return *rc::gen::container<std::string>(rc::gen::inRange<char>(0, 127));
    case ParameterType::names:
      return *rc::gen::container<std::vector<std::string>>(
          rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127)));
    case ParameterType::vec2:
      return numbers(*rc::gen::elementOf(std::vector<std::size_t>{0, 2}));
    case ParameterType::vec3:
      return numbers(3);
    case ParameterType::tensor6:
      return numbers(6);
    case ParameterType::edge:
      if (*rc::gen::arbitrary<bool>()) return *rc::gen::elementOf(p.choices);
      [[fallthrough]];
    case ParameterType::length: {
      const double number = *real_in(p.range);
      if (*rc::gen::arbitrary<bool>()) return number;
      return format_length(
          {number, *rc::gen::elementOf(std::vector<LengthUnit>{
                       LengthUnit::millimetre, LengthUnit::inch, LengthUnit::percent})});
    }
  }
  return 0.0;
}

Recipe arbitrary_recipe() {
  Recipe recipe;
  recipe.simulation.impacts.resize(*rc::gen::inRange<std::size_t>(0, 4));
  for (const Parameter& p : parameter_table()) {
    const std::size_t copies = p.repeated() ? recipe.simulation.impacts.size() : 1;
    for (std::size_t i = 0; i < copies; ++i) p.set(recipe, i, arbitrary_value(p));
  }
  return recipe;
}

RC_GTEST_PROP(Recipe, ReadsBackEqualFromItsOwnToml, ()) {
  const Recipe recipe = arbitrary_recipe();
  RC_ASSERT(read_recipe(write_recipe(recipe), "written") == recipe);
}

RC_GTEST_PROP(Recipe, IsRebuiltFromSettingsAlone, ()) {
  const Recipe recipe = arbitrary_recipe();
  Recipe rebuilt;
  for (const Parameter& p : parameter_table()) {
    const std::size_t copies = p.repeated() ? recipe.simulation.impacts.size() : 1;
    for (std::size_t i = 0; i < copies; ++i) {
      const std::string key = p.repeated() ? "impact." + std::to_string(i) + "." + p.name() : p.key;
      apply_set(rebuilt, key + "=" + format_value(p.get(recipe, i)));
    }
  }
  RC_ASSERT(rebuilt == recipe);
}

TEST(Recipe, SaysNothingAndKeepsTheDefaults) {
  EXPECT_TRUE(read_recipe("", "empty") == Recipe{});
}

TEST(Recipe, KeepsOfItsBaseWhatItDoesNotGive) {
  Recipe base;
  base.simulation.material.toughness = 3;
  base.simulation.impacts.emplace_back();
  const Recipe recipe = read_recipe("[material]\nalpha = 1", "r", base);
  EXPECT_EQ(recipe.simulation.material.toughness, 3);
  EXPECT_EQ(recipe.simulation.material.alpha, 1);
  EXPECT_EQ(recipe.simulation.impacts.size(), 1u);
}

TEST(Recipe, TakesTheExampleOfTheContract) {
  const Recipe recipe = read_recipe(R"(
engine = "euler"
seed = 9
[mesh]
edge = 0.5
[stress]
tensor = [1, 0, 0, 0, 0, 2.5]
[[impact]]
point = [0, 1, 0]
[[impact]]
radius = 2
[boundary]
default = "fixed"
)",
                                    "r");
  EXPECT_EQ(recipe.simulation.seed, 9u);
  EXPECT_EQ(recipe.mesh.edge.kind, EdgeLength::Kind::given);
  EXPECT_EQ(recipe.mesh.edge.length, 0.5);
  EXPECT_EQ(recipe.simulation.stress.tensor[5], 2.5);
  ASSERT_EQ(recipe.simulation.impacts.size(), 2u);
  EXPECT_EQ(recipe.simulation.impacts[0].point.y(), 1);
  EXPECT_EQ(recipe.simulation.impacts[1].radius, 2);
  EXPECT_EQ(recipe.simulation.boundary.kind, BoundaryKind::fixed);
}

TEST(Recipe, UnknownKeysNameThePlaceAndTheNearestKnownOne) {
  EXPECT_EQ(read_error("seed = 2\n[material]\ntougness = 1"),
            "unknown key material.tougness (r.toml:3:12): did you mean material.toughness?");
  EXPECT_NE(read_error("[materials]\nalpha = 1").find("did you mean material.alpha?"),
            std::string::npos);
  EXPECT_NE(read_error("alpha = 1").find("did you mean material.alpha?"), std::string::npos);
  EXPECT_NE(read_error("[[impacts]]\nradius = 1").find("did you mean impact?"), std::string::npos);
  EXPECT_NE(read_error("preset = \"mud\"").find("give --preset"), std::string::npos);
  EXPECT_NE(read_error("[[impact]]\nradus = 1").find("did you mean impact.radius?"),
            std::string::npos);
  EXPECT_NE(read_error("zzzzzzzzz = 1").find("craze parameters"), std::string::npos);
  EXPECT_NE(read_error("[nothing]").find("unknown key nothing"), std::string::npos);
  EXPECT_NE(read_error("\"\" = 1").find("unknown key"), std::string::npos);
}

TEST(Recipe, WrongTypesSayWhatIsWanted) {
  EXPECT_EQ(read_error("[material]\nalpha = \"high\""),
            "wrong type for material.alpha (r.toml:2:9): must be a number");
  EXPECT_NE(read_error("seed = 1.5").find("a whole number"), std::string::npos);
  EXPECT_NE(read_error("[stress]\ntensor = [1, 2]").find("six numbers"), std::string::npos);
  EXPECT_NE(read_error("[stress]\ntensor = [1, 2, 3, 4, 5, true]").find("six numbers"),
            std::string::npos);
  EXPECT_NE(read_error("[stress]\nattribute = 3").find("a text"), std::string::npos);
  EXPECT_NE(read_error("[material]\nalpha = 1979-05-27").find("a number"), std::string::npos);
  EXPECT_NE(read_error("[impact]\nradius = 1").find("[[impact]]"), std::string::npos);
  EXPECT_NE(read_error("material = 1").find("must be a section"), std::string::npos);
  EXPECT_NE(read_error("[material.alpha]\nx = 1").find("must be a number"), std::string::npos);
}

TEST(Recipe, ValuesOutOfRangeSayTheRange) {
  EXPECT_EQ(read_error("[material]\nalpha = -1"),
            "material.alpha = -1 is out of range (r.toml:2:9): must be in [0, 1]");
  EXPECT_NE(read_error("[evolution]\ntime_step = 0").find("more than 0"), std::string::npos);
  EXPECT_NE(read_error("seed = -3").find("must be in [0, "), std::string::npos);
  EXPECT_NE(read_error("[material]\nalpha = nan").find("not finite"), std::string::npos);
  EXPECT_NE(read_error("[stress]\nuniform = -inf").find("not finite"), std::string::npos);
  EXPECT_NE(read_error("[stress]\nuniform = 1e999").find("r.toml"), std::string::npos);
  EXPECT_NE(read_error("engine = \"eular\"").find("did you mean euler?"), std::string::npos);
  EXPECT_NE(read_error("[mesh]\nedge = \"fine\"").find("auto or keep or a length"),
            std::string::npos);
}

TEST(Recipe, BrokenTomlNamesLineAndColumnOnOneLine) {
  const std::string message = read_error("seed = 1\n[material\nalpha = 1");
  EXPECT_EQ(message.find("not a TOML recipe (r.toml:2:"), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(Recipe, HostileSizeAndNestingAreRefused) {
  EXPECT_NE(read_error(std::string(2 << 20, '#')).find("larger"), std::string::npos);
  std::string dots = "a";
  for (int i = 0; i < 200000; ++i) dots += ".a";
  EXPECT_NE(read_error(dots + " = 1").find("nested too deep"), std::string::npos);
  EXPECT_NE(read_error("[" + dots + "]").find("nested too deep"), std::string::npos);
  EXPECT_NE(read_error("x = " + std::string(100000, '[')).find("r.toml:1:"), std::string::npos);
  std::string tables = "x = ";
  for (int i = 0; i < 50000; ++i) tables += "{a.b.c.d.e=";
  EXPECT_NE(read_error(tables).find("r.toml"), std::string::npos);
}

TEST(Recipe, DotsInTextsAndCommentsAreNoNesting) {
  const Recipe recipe = read_recipe(
      "# … and so on ...................................\n[stress]\n"
      "texture = \"../../../../../../../../../../../../../../../../../../a.b.png\"",
      "r");
  EXPECT_EQ(recipe.simulation.stress.texture.find("../"), 0u);
}

TEST(Set, TakesBareWordsWherePlainTextIsMeant) {
  Recipe recipe;
  apply_set(recipe, "engine=quasistatic");
  apply_set(recipe, "mesh.edge=keep");
  apply_set(recipe, "stress.attribute=123");
  EXPECT_EQ(recipe.simulation.engine, Engine::quasistatic);
  EXPECT_EQ(recipe.mesh.edge.kind, EdgeLength::Kind::keep);
  EXPECT_EQ(recipe.simulation.stress.attribute, "123");
  apply_set(recipe, "mesh.edge=0.25");
  EXPECT_EQ(recipe.mesh.edge.length, 0.25);
  apply_set(recipe, "stress.attribute=\"a \\\" b\"");
  EXPECT_EQ(recipe.simulation.stress.attribute, "a \" b");
  apply_set(recipe, "stress.attribute=");
  EXPECT_EQ(recipe.simulation.stress.attribute, "");
}

TEST(Set, TakesOneNameOrAListOfThem) {
  Recipe recipe;
  const std::vector<std::string>& names = recipe.simulation.where.nodes;
  apply_set(recipe, "where.nodes=door*");
  EXPECT_EQ(names, (std::vector<std::string>{"door*"}));
  apply_set(recipe, "where.nodes=[\"a 1.\", \".5\"]");
  EXPECT_EQ(names, (std::vector<std::string>{"a 1.", ".5"}));
  apply_set(recipe, "where.nodes=");
  EXPECT_TRUE(names.empty());
  EXPECT_NE(set_error("where.nodes=[a, b]").find("a list of names"), std::string::npos);
}

TEST(Set, ReachesEachImpactByItsNumberAndAppendsTheNext) {
  Recipe recipe;
  apply_set(recipe, "impact.0.radius=2");
  apply_set(recipe, "impact.1.point=[1,2,3]");
  apply_set(recipe, "impact.0.hoop=0");
  ASSERT_EQ(recipe.simulation.impacts.size(), 2u);
  EXPECT_EQ(recipe.simulation.impacts[0].radius, 2);
  EXPECT_EQ(recipe.simulation.impacts[0].hoop, 0);
  EXPECT_EQ(recipe.simulation.impacts[1].point.z(), 3);
}

TEST(Set, ErrorsNameTheSetting) {
  EXPECT_EQ(set_error("material.tougness=1"),
            "unknown key material.tougness (--set material.tougness=1): did you mean "
            "material.toughness?");
  EXPECT_NE(set_error("material.alpha=2").find("in [0, 1]"), std::string::npos);
  EXPECT_NE(set_error("seed=9007199254740993").find("= 9007199254740993 is out of range"),
            std::string::npos);
  EXPECT_NE(set_error("material.alpha=high").find("a number"), std::string::npos);
  EXPECT_NE(set_error("material.alpha=").find("a number"), std::string::npos);
  EXPECT_NE(set_error("material.alpha=1\nseed=2").find("a number"), std::string::npos);
  EXPECT_NE(set_error("material.alpha").find("key=value"), std::string::npos);
  EXPECT_NE(set_error("=1").find("key=value"), std::string::npos);
  EXPECT_NE(set_error("impact.radius=1").find("impact.0.radius"), std::string::npos);
  EXPECT_NE(set_error("impact.1.radius=1").find("impact.0"), std::string::npos);
  EXPECT_NE(set_error("impact.0.radius=0").find("more than 0"), std::string::npos);
  EXPECT_NE(set_error("impact.99999999999999999999.radius=1").find("impact"), std::string::npos);
  EXPECT_NE(set_error("stress.attribute=\xff").find("UTF-8"), std::string::npos);
  EXPECT_NE(set_error("stress.attribute=\"open").find("a text"), std::string::npos);
}

TEST(RecipeJson, HoldsSectionsAndImpacts) {
  Recipe recipe;
  recipe.simulation.impacts.resize(2);
  recipe.simulation.impacts[1].radius = 5;
  const auto json = recipe_to_json(recipe);
  EXPECT_EQ(json["engine"], "quasistatic");
  EXPECT_EQ(json["material"]["alpha"], 0.5);
  EXPECT_EQ(json["impact"].size(), 2u);
  EXPECT_EQ(json["impact"][1]["radius"], 5.0);
  EXPECT_EQ(recipe_to_json(Recipe{})["impact"].size(), 0u);
}

TEST(SetKey, NamesWhatItWasTold) {
  Recipe recipe;
  set_key(recipe, "seed", "7", "seed of a program");
  EXPECT_EQ(recipe.simulation.seed, 7u);
  const Recipe before = recipe;
  for (const char* value : {"-1", "much", "[1]", "7\nengine = \"euler\""}) {
    const std::string message =
        error_of([&] { set_key(recipe, "seed", value, "seed of a program"); }, ErrorKind::usage);
    EXPECT_NE(message.find("(seed of a program)"), std::string::npos) << message;
    EXPECT_EQ(message.find("--set"), std::string::npos) << message;
    EXPECT_TRUE(recipe == before);
  }
}

TEST(Recipe, WhatIsGivenTakesBackWhatSaysTheSameInAnotherWay) {
  Recipe wide;
  apply_set(wide, "post.gap_width=1%");
  apply_set(wide, "post.relative_roughness=0.06");
  const PostParameters by_text = read_recipe("[post]\ngap = 0\nroughness = 0.2", "text", wide).post;
  EXPECT_EQ(by_text.gap, 0);
  EXPECT_EQ(by_text.gap_width.number(), 0);
  EXPECT_EQ(by_text.roughness.number(), 0.2);
  EXPECT_EQ(by_text.relative_roughness, 0);
}

TEST(Recipe, BothWaysInOneTextAreLeftForTheCheckToRefuse) {
  const Recipe both = read_recipe("[post]\ngap = 0.1\ngap_width = 0.2", "text");
  EXPECT_EQ(both.post.gap, 0.1);
  EXPECT_EQ(both.post.gap_width.number(), 0.2);
}

TEST(ParameterTable, WhatSaysTheSameInAnotherWayDoesSoBothWaysInOneSection) {
  for (const Parameter& p : parameter_table()) {
    if (p.instead_of.empty()) continue;
    const Parameter* other = find_parameter(p.instead_of);
    ASSERT_TRUE(other) << p.key;
    EXPECT_EQ(other->instead_of, p.key);
    EXPECT_EQ(other->section(), p.section());
  }
}

}  // namespace
}  // namespace craze
