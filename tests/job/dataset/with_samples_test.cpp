#include <gtest/gtest.h>

#include "craze/job/dataset/dataset.h"

namespace craze {
namespace {

std::string with_nine(const std::string& text) {
  return with_samples({text, "p.toml", "/"}, 9).text;
}

TEST(WithSamples, ChangesTheNumberAndNothingElse) {
  EXPECT_EQ(with_nine("seed = 2\nsamples = 1_000  # many\nclean = 0.5\n"),
            "seed = 2\nsamples = 9  # many\nclean = 0.5\n");
  EXPECT_EQ(with_nine("# \u00e4\n\"samples\"=0x10"), "# \u00e4\n\"samples\"=9");
}

TEST(WithSamples, GivesANumberToAPlanWithoutOne) {
  EXPECT_EQ(with_nine("clean = 0\n"), "samples = 9\nclean = 0\n");
}

TEST(WithSamples, LeavesWhatOnlyLooksLikeTheKey) {
  const std::string text = "seed = 1\nobject.mesh = \"\"\"\nsamples = 3\n\"\"\"\n";
  EXPECT_EQ(with_nine(text), "samples = 9\n" + text);
}

TEST(WithSamples, TakesJsonToo) {
  EXPECT_EQ(with_nine("{\"samples\": 4}"), "{\n  \"samples\": 9\n}");
}

}  // namespace
}  // namespace craze
