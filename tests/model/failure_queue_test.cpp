#include "craze/model/failure/failure_queue.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace craze {
namespace {

// The obvious queue: look at everything.
class Reference {
 public:
  void set(std::int32_t v, double measure) {
    measures_.erase(v);
    if (measure > 0) measures_[v] = measure;
  }
  bool empty() const { return measures_.empty(); }
  double measure(std::int32_t v) const { return measures_.count(v) ? measures_.at(v) : 0; }
  std::int32_t top() const {
    std::int32_t best = -1;
    for (const auto& [v, m] : measures_) {
      if (best < 0 || m > measures_.at(best)) best = v;
    }
    return best;
  }

 private:
  std::map<std::int32_t, double> measures_;
};

RC_GTEST_PROP(FailureQueue, BehavesLikeLookingThroughAllNodes,
              (const std::vector<std::pair<std::uint8_t, std::int8_t>>& operations)) {
  FailureQueue queue;
  Reference reference;
  for (const auto& [node, value] : operations) {
    const std::int32_t v = node % 64;
    queue.set(v, value / 8);  // few distinct measures: ties are common
    reference.set(v, value / 8);
    RC_ASSERT(queue.empty() == reference.empty());
    RC_ASSERT(queue.measure(v) == reference.measure(v));
    if (!queue.empty()) RC_ASSERT(queue.top() == reference.top());
  }
  while (!queue.empty()) {
    RC_ASSERT(queue.top() == reference.top());
    reference.set(queue.top(), 0);
    queue.remove(queue.top());
  }
  RC_ASSERT(reference.empty());
}

TEST(FailureQueue, TheLargestEigenvalueIsOnTopAndTiesGoToTheLowerNode) {
  FailureQueue queue;
  queue.set(7, 1.0);
  queue.set(3, 2.0);
  queue.set(5, 2.0);
  EXPECT_EQ(queue.top(), 3);
  queue.remove(3);
  EXPECT_EQ(queue.top(), 5);
  queue.set(7, 9.0);
  EXPECT_EQ(queue.top(), 7);
}

TEST(FailureQueue, ANodeWithoutAPositiveMeasureIsNotQueued) {
  FailureQueue queue;
  queue.set(2, 0);
  queue.set(4, -1);
  queue.remove(1000);
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(queue.measure(2), 0);
  EXPECT_EQ(queue.measure(1000), 0);
}

TEST(FailureQueue, TellsTheFirstNodesFromAMeasureOn) {
  FailureQueue queue;
  for (std::int32_t v = 0; v < 100; ++v) queue.set(v, 0.01 * ((37 * v) % 100 / 2) + 1);
  EXPECT_TRUE(queue.first(1, 100).empty());  // nothing is in the heap as yet
  queue.top();
  std::vector<std::int32_t> expected;
  for (std::int32_t v = 0; v < 100; ++v) {
    if (queue.measure(v) >= 1.445) expected.push_back(v);
  }
  EXPECT_EQ(expected.size(), 10U);
  std::stable_sort(expected.begin(), expected.end(), [&](std::int32_t a, std::int32_t b) {
    return queue.measure(a) > queue.measure(b);
  });
  EXPECT_EQ(queue.first(1.445, 100), expected);
  expected.resize(3);
  EXPECT_EQ(queue.first(1.445, 3), expected);
  EXPECT_TRUE(queue.first(3, 100).empty());
}

}  // namespace
}  // namespace craze
