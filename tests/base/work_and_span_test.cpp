// What a run would take on many cores, from its times on one.
#include "craze/base/work_and_span.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace craze {
namespace {

TEST(WorkAndSpan, ATaskGoesToTheCoreThatIsFreeFirst) {
  const std::vector<double> tasks = {3, 1, 1, 1, 4};
  EXPECT_EQ(time_on_cores(tasks, 1), 10);
  EXPECT_EQ(time_on_cores(tasks, 2), 7);  // 3 + 4 beside 1 + 1 + 1
  EXPECT_EQ(time_on_cores(tasks, 3), 5);  // 1 + 4 beside 3 and 1 + 1
  EXPECT_EQ(time_on_cores(tasks, 5), 4);
  EXPECT_EQ(time_on_cores({}, 2), 0);
}

TEST(WorkAndSpan, CoresSaveNoMoreThanTheirNumberAndNeverBeatTheLongestTask) {
  std::vector<double> tasks;
  for (int i = 0; i < 100; ++i) tasks.push_back(1 + 7 * i % 13);
  const double work = std::accumulate(tasks.begin(), tasks.end(), 0.0);
  const double longest = *std::max_element(tasks.begin(), tasks.end());
  double before = work;
  for (const int cores : {1, 2, 3, 4, 8, 16, 64, 1000}) {
    const double time = time_on_cores(tasks, cores);
    EXPECT_GE(time, std::max(work / cores, longest)) << cores;
    EXPECT_LE(time, work / cores + longest) << cores;  // Graham's bound for lists
    EXPECT_LE(time, before) << cores;
    before = time;
  }
}

TEST(WorkAndSpan, StretchesInOneThreadAreNoShorterOnMoreCores) {
  WorkAndSpan record;
  record.add("solve", 2, {1, 1, 1, 1});
  record.add("look", 1, {0.5, 0.5});
  record.add("solve", 3, {1, 1});
  ASSERT_EQ(record.rows().size(), 2);
  const WorkAndSpan::Row& solve = record.rows().at("solve");
  EXPECT_EQ(solve.loops, 2);
  EXPECT_EQ(solve.tasks, 6);
  EXPECT_EQ(solve.before, 5);
  ASSERT_EQ(WorkAndSpan::cores[0], 1);
  ASSERT_EQ(WorkAndSpan::cores[1], 2);
  EXPECT_EQ(solve.inside[0], 6);
  EXPECT_EQ(solve.inside[1], 3);
  EXPECT_EQ(record.total(0, 4), 4 + 6 + 7);
  EXPECT_EQ(record.total(1, 4), 4 + 6 + 3.5);
}

}  // namespace
}  // namespace craze
