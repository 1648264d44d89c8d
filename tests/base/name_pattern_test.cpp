#include "craze/base/name_pattern.h"

#include <gtest/gtest.h>

#include <string>

namespace craze {
namespace {

TEST(APattern, FitsTheWholeNameOrNothing) {
  EXPECT_TRUE(fits_pattern("leather", "leather"));
  EXPECT_FALSE(fits_pattern("leather", "leathe"));
  EXPECT_FALSE(fits_pattern("leathe", "leather"));
  EXPECT_FALSE(fits_pattern("Leather", "leather"));
  EXPECT_TRUE(fits_pattern("", ""));
  EXPECT_FALSE(fits_pattern("a", ""));
}

TEST(APattern, HasStarsForAnyLettersAndQuestionMarksForOne) {
  EXPECT_TRUE(fits_pattern("door_front.001", "door*"));
  EXPECT_TRUE(fits_pattern("door", "door*"));
  EXPECT_TRUE(fits_pattern("front_door_left", "*door*"));
  EXPECT_FALSE(fits_pattern("front_window", "*door*"));
  EXPECT_TRUE(fits_pattern("door1", "door?"));
  EXPECT_FALSE(fits_pattern("door", "door?"));
  EXPECT_TRUE(fits_pattern("abcabxd", "*ab?d"));
  EXPECT_TRUE(fits_pattern("", "**"));
}

TEST(APattern, CountsLettersNotBytes) {
  EXPECT_TRUE(fits_pattern("Tür", "T?r"));
  EXPECT_FALSE(fits_pattern("Tür", "T??r"));
}

TEST(APattern, OfManyStarsTakesNoLongTime) {
  std::string pattern;
  for (int i = 0; i < 2000; ++i) pattern += "*a";
  EXPECT_FALSE(fits_pattern(std::string(4000, 'a') + "b", pattern));
}

}  // namespace
}  // namespace craze
