#include "craze/job/dataset/dataset_plan.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

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

TEST(DatasetPlans, SeeMarksThatAreNoCracksAndPicturesWithoutAny) {
  for (const auto& entry : fs::directory_iterator(root / "recipes/datasets")) {
    const Plan plan(text_of(entry.path()), entry.path().filename().string(), dataset_schema());
    int marked = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
      const PlanValues values = plan.draw(i);
      for (const char* kind : {"shadow", "stain", "joint", "scratch", "seam"}) {
        marked += number_of(values, std::string("distractors.") + kind) > 0;
      }
    }
    EXPECT_GT(marked, 50) << entry.path();
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
