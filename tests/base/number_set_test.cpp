#include "craze/base/number_set.h"

#include <gtest/gtest.h>

#include <set>

namespace craze {
namespace {

TEST(NumberSet, HoldsWhatASetHolds) {
  NumberSet numbers;
  std::set<std::uint64_t> same;
  EXPECT_FALSE(numbers.contains(0));
  const Random random(7, 0);
  for (std::uint64_t i = 0; i < 5000; ++i) {
    // Many come twice, some lie side by side, and some are large.
    const auto x = static_cast<std::uint64_t>(random.uniform_at(i) * 3000) << (i % 3 == 0 ? 40 : 0);
    numbers.insert(x);
    same.insert(x);
  }
  for (std::uint64_t x = 0; x < 4000; ++x) {
    ASSERT_EQ(numbers.contains(x), same.count(x) > 0) << x;
    ASSERT_EQ(numbers.contains(x << 40), same.count(x << 40) > 0) << x;
  }
  numbers.clear();
  EXPECT_FALSE(numbers.contains(*same.begin()));
}

}  // namespace
}  // namespace craze
