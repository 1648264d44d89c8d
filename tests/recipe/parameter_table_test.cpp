#include "craze/recipe/parameter_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "craze/error.h"

namespace craze {
namespace {

// The names and defaults are a contract with every recipe ever written: this list is typed by hand
// on purpose.
TEST(ParameterTable, HoldsEveryKeyOfTheContractWithItsDefault) {
  const std::vector<std::pair<std::string, std::string>> contract{
      {"engine", "\"quasistatic\""},
      {"seed", "1"},
      {"mesh.edge", "\"auto\""},
      {"stress.uniform", "1.0"},
      {"stress.tensor", "[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]"},
      {"stress.noise", "0.05"},
      {"stress.noise_length", "0.0"},
      {"stress.curvature", "0.0"},
      {"stress.curvature_radius", "0.0"},
      {"stress.attribute", "\"\""},
      {"stress.texture", "\"\""},
      {"impact.point", "[0.0, 0.0, 0.0]"},
      {"impact.radius", "1.0"},
      {"impact.radial", "0.0"},
      {"impact.hoop", "1.0"},
      {"impact.falloff", "2.0"},
      {"material.toughness", "1.0"},
      {"material.strength", "1.0"},
      {"material.criterion", "\"force\""},
      {"material.alpha", "0.5"},
      {"material.scatter", "0.0"},
      {"material.curvature_scale", "\"none\""},
      {"material.bias", "0.0"},
      {"layer.spacing", "0.0"},
      {"layer.screening_length", "0.0"},
      {"evolution.shrinkage", "0.0"},
      {"evolution.curvature_growth", "0.0"},
      {"evolution.time_step", "0.1"},
      {"evolution.relaxation_steps", "1"},
      {"evolution.cracks_per_step", "1"},
      {"evolution.max_load", "4.0"},
      {"evolution.max_cracks", "0"},
      {"evolution.onset_attribute", "\"\""},
      {"evolution.onset_texture", "\"\""},
      {"evolution.onset_speed", "0.0"},
      {"evolution.onset_point", "[0.0, 0.0, 0.0]"},
      {"evolution.onset_direction", "[0.0, 0.0, 0.0]"},
      {"evolution.place_load", "0.0"},
      {"boundary.default", "\"free\""},
      {"boundary.fixed_attribute", "\"\""},
      {"crack.snap_angle", "25.0"},
      {"crack.back_angle", "15.0"},
      {"post.gap", "0.0"},
      {"post.wall", "0.0"},
      {"post.curl", "0.0"},
  };
  for (const auto& [key, value] : contract) {
    const Parameter* p = find_parameter(key);
    ASSERT_TRUE(p) << key;
    EXPECT_EQ(format_value(p->default_value()), value) << key;
  }
}

TEST(ParameterTable, EachKeyStandsOnceAndItsSectionInOnePlace) {
  std::set<std::string> keys, closed_sections;
  std::string section;
  for (const Parameter& p : parameter_table()) {
    EXPECT_TRUE(keys.insert(p.key).second) << p.key;
    if (p.section() != section) {
      EXPECT_TRUE(closed_sections.insert(section).second) << p.section();
      section = p.section();
    }
  }
}

TEST(ParameterTable, EveryDefaultIsAllowed) {
  for (const Parameter& p : parameter_table()) {
    EXPECT_NO_THROW(check_value(p, p.default_value(), p.key, "")) << p.key;
    EXPECT_FALSE(p.help.empty()) << p.key;
  }
}

TEST(ParameterTable, SettingAFieldChangesThatFieldAndNoOther) {
  for (const Parameter& p : parameter_table()) {
    Recipe recipe;
    recipe.simulation.impacts.emplace_back();
    const Recipe before = recipe;
    ParameterValue other = p.default_value();
    if (auto* real = std::get_if<double>(&other)) *real += 0.25;
    if (auto* integer = std::get_if<std::int64_t>(&other)) *integer += 3;
    if (auto* numbers = std::get_if<std::vector<double>>(&other)) {
      numbers->resize(std::max<std::size_t>(numbers->size(), 2), 0);
      numbers->back() = 7;
    }
    if (auto* names = std::get_if<std::vector<std::string>>(&other)) names->push_back("painted");
    if (auto* boolean = std::get_if<bool>(&other)) *boolean = !*boolean;
    if (auto* word = std::get_if<std::string>(&other)) {
      const bool last = !p.choices.empty() && *word == p.choices.back();
      *word = p.choices.empty() ? "painted" : last ? p.choices.front() : p.choices.back();
    }
    p.set(recipe, 0, other);
    for (const Parameter& q : parameter_table()) {
      EXPECT_EQ(q.get(recipe, 0) == q.get(before, 0), q.key != p.key) << p.key << " " << q.key;
    }
  }
}

TEST(ParameterTable, TheJsonDumpHoldsEveryParameterWithItsRange) {
  const auto json = parameters_to_json();
  ASSERT_EQ(json.size(), parameter_table().size());
  for (const auto& entry : json) {
    if (entry["key"] == "crack.snap_angle") {
      EXPECT_EQ(entry["minimum"], 0.0);
      EXPECT_EQ(entry["maximum"], 90.0);
      EXPECT_EQ(entry["default"], 25.0);
      EXPECT_EQ(entry["unit"], "degrees");
    }
    EXPECT_EQ(entry["repeated"], entry["section"] == "impact");
  }
}

TEST(ParameterRange, OpenEndsExcludeTheirNumber) {
  const ParameterRange positive{0, ParameterRange{}.high, true};
  EXPECT_FALSE(positive.contains(0));
  EXPECT_TRUE(positive.contains(1e-300));
  EXPECT_EQ(range_in_words(positive, ParameterType::real), "more than 0");
  EXPECT_EQ(range_in_words({0, 1}, ParameterType::real), "in [0, 1]");
}

}  // namespace
}  // namespace craze
