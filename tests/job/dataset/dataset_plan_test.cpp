#include "craze/job/dataset/dataset_plan.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "craze/error.h"
#include "craze/job/sweep/sweep_rows.h"

namespace craze {
namespace {

namespace fs = std::filesystem;

const fs::path root = CRAZE_SOURCE_DIR;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(DatasetPlans, ThatShipCanBeDrawn) {
  int plans = 0;
  for (const auto& entry : fs::directory_iterator(root / "recipes/datasets")) {
    ++plans;
    const Plan plan(text_of(entry.path()), entry.path().filename().string(), dataset_schema());
    EXPECT_GT(dataset_shape(plan).clean, 0) << entry.path();
    for (std::uint64_t i = 0; i < 300; ++i) EXPECT_NO_THROW(recipe_of(plan, plan.draw(i), 1));
  }
  EXPECT_EQ(plans, 5);
}

std::vector<PlanKey> keys_in(const std::string& section) {
  std::vector<PlanKey> keys;
  for (const PlanKey& key : dataset_schema().keys) {
    if (key.key.rfind(section + ".", 0) == 0) keys.push_back(key);
  }
  return keys;
}

TEST(DatasetPlans, SeeMarksThatAreNoCracksAndPicturesWithoutAny) {
  for (const auto& entry : fs::directory_iterator(root / "recipes/datasets")) {
    const Plan plan(text_of(entry.path()), entry.path().filename().string(), dataset_schema());
    int marked = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
      const PlanValues values = plan.draw(i);
      for (const PlanKey& kind : keys_in("distractors")) marked += number_of(values, kind.key) > 0;
    }
    EXPECT_GT(marked, 150) << entry.path();
  }
}

TEST(DatasetPlans, HaveEveryKindOfMarkAndPatternInOneOfThem) {
  std::map<std::string, int> seen;
  for (const auto& entry : fs::directory_iterator(root / "recipes/datasets")) {
    const Plan plan(text_of(entry.path()), entry.path().filename().string(), dataset_schema());
    for (std::uint64_t i = 0; i < 100; ++i) {
      const PlanValues values = plan.draw(i);
      for (const PlanKey& kind : keys_in("distractors")) {
        seen[kind.key] += number_of(values, kind.key) > 0;
      }
      for (const char* key : {"veins", "bricks", "flaking", "specks", "aggregate"}) {
        const std::string full = std::string("surface.") + key;
        seen[full] += number_of(values, full) != 0;
      }
    }
  }
  EXPECT_EQ(seen.size(), 18u);
  for (const auto& [key, count] : seen) EXPECT_GT(count, 5) << key;
}

TEST(DatasetPlans, DifferInTheirSeedsSoThatTheirDrawsDo) {
  std::set<double> seeds;
  for (const auto& entry : fs::directory_iterator(root / "recipes/datasets")) {
    const Plan plan(text_of(entry.path()), entry.path().filename().string(), dataset_schema());
    EXPECT_TRUE(seeds.insert(plan.number("seed")).second) << entry.path();
  }
}

TEST(DatasetPlans, AreRefusedWhereALookOrAMarkIsOutOfItsRange) {
  for (const char* section : {"surface", "lines", "distractors"}) {
    for (const PlanKey& key : keys_in(section)) {
      if (key.type == PlanKeyType::word) continue;
      for (const double value : {key.low - 1, key.high + 1}) {
        EXPECT_THROW(
            Plan(key.key + " = " + std::to_string(value), "p.toml", dataset_schema()).draw(0),
            Error)
            << key.key << " = " << value;
      }
    }
  }
}

TEST(PlanPages, ListTheKeysThereAre) {
  EXPECT_NE(text_of(root / "docs/datasets.md").find(plan_reference(dataset_schema())),
            std::string::npos)
      << plan_reference(dataset_schema());
  EXPECT_NE(text_of(root / "docs/sweeps.md").find(plan_reference(sweep_schema())),
            std::string::npos)
      << plan_reference(sweep_schema());
}

}  // namespace
}  // namespace craze
