#include "craze/length.h"

#include <gtest/gtest.h>

#include <cmath>

#include "craze/recipe/each_parameter.h"
#include "craze/recipe/length_text.h"
#include "craze/recipe/own_lengths.h"
#include "error_message.h"
#include "recipe_with.h"

namespace craze {
namespace {

/// The spacing in the mesh's own unit of a mesh whose unit is `metres`.
double spacing_of(const std::string& length, double metres, double diagonal = 1) {
  return with_own_lengths(recipe_with({"layer.spacing=" + length}), {diagonal, metres})
      .simulation.layer.spacing;
}

TEST(ALength, IsMeasuredInTheMeshsOwnUnit) {
  EXPECT_DOUBLE_EQ(spacing_of("4mm", 1), 0.004);
  EXPECT_DOUBLE_EQ(spacing_of("4mm", 0.001), 4);
  EXPECT_DOUBLE_EQ(spacing_of("2cm", 1), 0.02);
  EXPECT_DOUBLE_EQ(spacing_of("0.5in", 0.0254), 0.5);
  EXPECT_DOUBLE_EQ(spacing_of("1ft", 1), 0.3048);
  EXPECT_DOUBLE_EQ(spacing_of("250um", 0.001), 0.25);
  EXPECT_DOUBLE_EQ(spacing_of("0.002km", 1), 2);
  EXPECT_DOUBLE_EQ(spacing_of(".5m", 1), 0.5);
  EXPECT_DOUBLE_EQ(spacing_of("+1e-1m", 1), 0.1);
}

TEST(ALength, InPercentIsOfTheDiagonalAndNeedsNoUnitOfTheMesh) {
  EXPECT_DOUBLE_EQ(spacing_of("3%", 0, 50), 1.5);
}

TEST(ALength, ThatIsABareNumberStaysAsItIs) {
  EXPECT_EQ(spacing_of("0.1", 0, 50), 0.1);
  EXPECT_EQ(spacing_of("3", 0.001, 50), 3);
}

TEST(ALength, WithAUnitIsRefusedWhereTheMeshHasNone) {
  const std::string message = error_of([] { spacing_of("4mm", 0); });
  EXPECT_NE(message.find("layer.spacing"), std::string::npos) << message;
  EXPECT_NE(message.find("mesh.unit"), std::string::npos) << message;
  const Recipe given = recipe_with({"mesh.unit=mm"});
  EXPECT_EQ(metres_per_unit({}, given), 0.001);
  SurfaceMesh in_metres;
  in_metres.metres_per_unit = 1;
  EXPECT_EQ(metres_per_unit(in_metres, given), 1);
}

TEST(ALength, ThatIsNoneIsRefusedInOneLine) {
  for (const std::string text :
       {"4 mm", "mm", "%", "3%%", "4MM", "4m m", "4xm", "infmm", "nan%", "0x4mm", "4mm\n", "--4mm",
        "4e", "1e", "-", "", "1,5mm", "4mm5", "4µm"}) {
    Recipe recipe;
    const std::string message = error_of([&] { apply_set(recipe, "layer.spacing=" + text); });
    EXPECT_NE(message.find("not a length"), std::string::npos) << text << ": " << message;
    EXPECT_TRUE(recipe == Recipe{}) << text;
  }
  EXPECT_NE(error_of([] { recipe_with({"layer.spacing=-3mm"}); }).find("out of range"),
            std::string::npos);
  EXPECT_NE(error_of([] { recipe_with({"layer.spacing=1e999mm"}); }).find("not finite"),
            std::string::npos);
  EXPECT_NE(error_of([] { recipe_with({"impact.0.radius=0%"}); }).find("more than 0"),
            std::string::npos);
  const std::string huge =
      error_of([] { recipe_with({"layer.spacing=" + std::string(5000, '7') + "q"}); });
  EXPECT_EQ(huge.find('\n'), std::string::npos);
}

TEST(ALength, ThatComesOutBeyondItsRangeIsRefused) {
  EXPECT_NE(error_of([] { spacing_of("1e308km", 1e-6); }).find("out of range"), std::string::npos);
  EXPECT_NE(error_of([] {
              with_own_lengths(recipe_with({"mesh.edge=1e-320um"}), {1, 1000});
            }).find("mesh.edge"),
            std::string::npos);
}

// The table is where it says which keys are lengths.
TEST(EveryLengthKey, TakesUnitsAndKeepsWhatWasWritten) {
  int lengths = 0;
  for (const Parameter& p : parameter_table()) {
    EXPECT_EQ(p.is_length(), p.unit == "length") << p.key;
    if (!p.is_length()) continue;
    ++lengths;
    const std::string key = p.repeated() ? "impact.0." + p.name() : p.key;
    const Recipe recipe = recipe_with({key + "=2.50mm"});
    EXPECT_EQ(format_value(p.get(recipe, 0)), "\"2.5mm\"") << key;
    EXPECT_TRUE(read_recipe(write_recipe(recipe), "written") == recipe) << key;
    const Recipe own = with_own_lengths(recipe, {1, 1});
    EXPECT_EQ(format_value(p.get(own, 0)), "0.0025") << key;
  }
  EXPECT_GE(lengths, 11);
}

TEST(EveryLengthKey, MeansTheSameInTomlJsonAndSettings) {
  const Recipe set = recipe_with({"layer.spacing=4mm", "mesh.edge=1%"});
  EXPECT_TRUE(read_recipe("[layer]\nspacing = \"4mm\"\n[mesh]\nedge = \"1%\"", "r.toml") == set);
  EXPECT_TRUE(read_recipe(R"({"layer": {"spacing": "4mm"}, "mesh": {"edge": "1%"}})", "r.json") ==
              set);
  EXPECT_TRUE(recipe_with({"layer.spacing=\"4mm\"", "mesh.edge='1%'"}) == set);
}

TEST(ALength, IsNoNumberBeforeItIsMeasured) {
  EXPECT_THROW(static_cast<void>(Length(4, LengthUnit::millimetre) + 1), std::logic_error);
  EXPECT_EQ(Length(4) + 1, 5);
}

}  // namespace
}  // namespace craze
