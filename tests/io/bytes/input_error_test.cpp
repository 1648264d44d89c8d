#include "craze/io/bytes/input_error.h"

#include <gtest/gtest.h>

namespace craze {
namespace {

TEST(Printable, KeepsNamesInEveryScript) {
  for (const char* name : {"Tür 3", "壁", "root 🌱", "© me"}) EXPECT_EQ(printable(name), name);
}

TEST(Printable, HasNoControlCharactersAndNoBrokenOnes) {
  EXPECT_EQ(printable("a\nb\x7f"), "a?b?");
  EXPECT_EQ(printable("\x1b[2J"), "?[2J");
  EXPECT_EQ(printable("\u0085\u202e\u2066x\u2028"), "???x?");
  EXPECT_EQ(printable("T\xfcr"), "T?r") << "Latin-1";
  EXPECT_EQ(printable("\xe5\xa3"), "??") << "cut off";
}

TEST(Printable, IsCutBetweenCharacters) {
  std::string walls, shown;
  for (int i = 0; i < 41; ++i) walls += "壁";
  for (int i = 0; i < 40; ++i) shown += "壁";
  EXPECT_EQ(printable(walls), shown + "...");
  EXPECT_EQ(printable(shown), shown);
}

}  // namespace
}  // namespace craze
