#include "craze/job/plan/plan_text.h"

#include <gtest/gtest.h>

#include "craze/job/dataset/dataset_plan.h"
#include "craze/job/sweep/sweep_rows.h"

namespace craze {
namespace {

std::string without(const std::string& text) {
  return without_keys(text, "p.toml", {"samples", "draws"});
}

TEST(PlanText, LosesTheLinesOfItsKeysAndNothingElse) {
  EXPECT_EQ(without("seed = 1\nsamples = 3  # three\n[lines]\nwidth = 2\n"),
            "seed = 1\n[lines]\nwidth = 2\n");
  EXPECT_EQ(without("samples=3"), "");
  EXPECT_EQ(without("seed = 1\r\n\t\"samples\"  =  1_000\r\ndraws = 2"), "seed = 1\r\n");
  EXPECT_EQ(without("draws = 2\nsamples = 3\nclean = 0\n"), "clean = 0\n");
  const std::string none =
      "object.mesh = \"\"\"\nsamples = 3\n\"\"\"\n# draws = 2\n[x]\nsamples = 1\n";
  EXPECT_EQ(without(none), none);
  EXPECT_EQ(without("{\"samples\": 3, \"seed\": 1}"), without("{\"seed\": 1, \"draws\": 2}"));
}

TEST(PlanText, KeepsAByteOrderMarkInFront) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(with_number(mark + "clean = 0\n", "p", "samples", 9),
            mark + "samples = 9\nclean = 0\n");
  EXPECT_EQ(with_number(mark + "samples = 5\n", "p", "samples", 9), mark + "samples = 9\n");
  EXPECT_EQ(without(mark + "samples = 5\nclean = 0\n"), mark + "clean = 0\n");
}

TEST(PlanIdentity, IsThatOfThePlanHoweverFarItGoes) {
  const auto identity = [](const std::string& text) {
    return Plan(text, "p", dataset_schema()).identity();
  };
  EXPECT_EQ(identity("samples = 3\nclean = 0\n"), identity("clean = 0\nsamples = 1000000"));
  EXPECT_EQ(identity("clean = 0\n"), identity("samples = 4\nclean = 0\n"));
  EXPECT_NE(identity("clean = 0\n"), identity("clean = 0.5\n"));
  const std::string linked = "[lines]\nwidth = {linked = \"samples\"}\n";
  EXPECT_NE(identity("samples = 3\n" + linked), identity("samples = 4\n" + linked));
}

TEST(SweepRows, BeginWithThoseOfFewerDrawsOrRepeatsWhereTheyAreTheSame) {
  const auto rows = [](const std::string& text) {
    return SweepRows(Plan(text + "[recipe]\nlayer.relative_spacing = {uniform = [0.1, 0.2]}\n", "p",
                          sweep_schema()));
  };
  const struct {
    const char *before, *now;
    bool begin;
  } cases[] = {
      {"draws = 3\n", "draws = 5\n", true},
      {"draws = 3\nrepeats = 2\n", "draws = 4\nrepeats = 2\n", true},
      {"repeats = 2\n", "repeats = 7\n", true},
      {"draws = 3\n", "draws = 3 # three\n", true},
      {"draws = 5\n", "draws = 3\n", false},
      {"repeats = 7\n", "repeats = 2\n", false},
      {"draws = 3\nrepeats = 2\n", "draws = 3\nrepeats = 3\n", false},
      {"repeats = 4\n", "draws = 3\nrepeats = 4\n", true},
      {"repeats = 4\n", "draws = 3\nrepeats = 5\n", true},
      {"draws = 2\nrepeats = 4\n", "draws = 3\nrepeats = 5\n", false},
  };
  for (const auto& c : cases) {
    const SweepRows before = rows(c.before), now = rows(c.now);
    EXPECT_EQ(now.begin_with(before), c.begin) << c.before << c.now;
    bool same = before.count() <= now.count();
    for (std::uint64_t i = 0; same && i < before.count(); ++i) {
      PlanValues a = before.values(i), b = now.values(i);
      for (const char* key : {"draws", "repeats"}) b[key] = a[key];
      same = a == b && before.seed(i) == now.seed(i);
    }
    EXPECT_EQ(same, c.begin) << c.before << c.now;
  }
  const std::string axis = "object = {values = [\"shape:plate\", \"shape:cube\"]}\n";
  EXPECT_FALSE(rows("draws = 4\n" + axis).begin_with(rows("draws = 2\n" + axis)));
}

}  // namespace
}  // namespace craze
