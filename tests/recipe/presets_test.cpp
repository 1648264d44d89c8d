#include "craze/presets.h"
#include "craze/model/crack_network.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "craze/error.h"
#include "craze/recipe/nearest_name.h"
#include "craze/recipe/parameter_reference.h"
#include "engine/claims.h"

namespace craze {
namespace {

TEST(Presets, AreReadableAndDescribed) {
  ASSERT_FALSE(presets().empty());
  for (const Preset& preset : presets()) {
    EXPECT_EQ(preset.text.substr(0, 2), "# ") << preset.name;
    EXPECT_GT(preset.description().size(), 10u) << preset.name;
    EXPECT_NO_THROW(read_preset(std::string(preset.name))) << preset.name;
  }
}

TEST(Presets, AMisspeltNameIsMet) {
  try {
    find_preset("glaize");
    FAIL();
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "unknown preset (glaize): did you mean glaze?");
    EXPECT_EQ(e.kind(), ErrorKind::usage);
  }
}

/// Of the legs of the T's, the mean angle with their crossbar, over several seeds, degrees.
double leg_angle(const Recipe& recipe) {
  constexpr int seeds = 8;
  StatisticsOptions options;
  options.bootstrap.resamples = 0;
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const test::Cracked cracked = test::crack("plate?n=60&jitter=0.3", recipe, seed);
    const Simulation& s = cracked.simulation;
    sum +=
        compute_statistics(graph_from_network(crack_network(s), s.mesh()), options).leg_angle.value;
  }
  return sum / seeds;
}

TEST(Presets, CracksOfMudAndGlazeMeetSquarely) {
  for (const char* name : {"mud", "glaze"}) {
    Recipe recipe = test::coarse_preset(name, 0.06);
    EXPECT_GT(leg_angle(recipe), 85) << name;
    recipe.simulation.material.relative_lookahead = 0;
    EXPECT_LT(leg_angle(recipe), 84) << name;
  }
}

TEST(Reference, ThePageInTheDocsIsCurrent) {
  std::ifstream file(CRAZE_SOURCE_DIR "/docs/reference.md");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), parameter_page()) << "run: craze parameters --markdown > docs/reference.md";
}

TEST(NearestName, CountsSwapsAsOneMistake) {
  EXPECT_EQ(edit_distance("seed", "sede"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(nearest_name("sede", {"engine", "seed"}), "seed");
  EXPECT_EQ(nearest_name("curvatur", {"stress.noise", "stress.curvature"}), "stress.curvature");
  EXPECT_EQ(nearest_name("x", {"engine", "seed"}), "");
}

}  // namespace
}  // namespace craze
