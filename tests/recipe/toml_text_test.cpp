#include "craze/recipe/toml_text.h"

#include <gtest/gtest.h>

#include <string>

#include "craze/recipe.h"
#include "error_message.h"

namespace craze {
namespace {

constexpr std::size_t nowhere = std::string::npos;

// Characters that the TOML library's test for white space has no answer for, and some that it has.
const std::string letters[] = {"µ", "é", "\u1472", "\u1C80", "中", "\uFEFF", "😀", "\xFF"};

TEST(TomlText, KnowsWhereACharacterStandsThatIsNotAscii) {
  for (const std::string& letter : letters) {
    EXPECT_EQ(find_bare_non_ascii("a = 4" + letter), 5u) << letter;
    EXPECT_EQ(find_bare_non_ascii(letter == "\uFEFF" ? " " + letter : letter + " = 1"),
              letter == "\uFEFF" ? 1u : 0u);
    EXPECT_EQ(find_bare_non_ascii("a = \"x\"\nb = 'y'" + letter), 15u) << letter;
    EXPECT_EQ(find_bare_non_ascii("a = \"\"\"x\"\n\"y\"\"\"" + letter), 15u) << letter;
    EXPECT_EQ(find_bare_non_ascii("a = \"\"\"x\"\"\"\"\"" + letter), 13u) << "x and two quotes";
    EXPECT_EQ(find_bare_non_ascii("a = \"x\n" + letter), 7u) << "a string ends with its line";
    for (const std::string quote : {"\"", "'", "\"\"\"", "'''"}) {
      EXPECT_EQ(find_bare_non_ascii("a = " + quote + letter + quote + " # " + letter), nowhere);
      EXPECT_EQ(find_bare_non_ascii("a = " + quote + letter), nowhere) << "not closed";
    }
    EXPECT_EQ(find_bare_non_ascii("a = \"\\\"" + letter + "\""), nowhere) << "an escaped quote";
    EXPECT_EQ(find_bare_non_ascii("a = '\\' # " + letter), nowhere) << "no escapes in '";
    EXPECT_EQ(find_bare_non_ascii("# \"\n# " + letter), nowhere) << "a quote in a comment";
  }
  EXPECT_EQ(find_bare_non_ascii("\uFEFFa = 1"), nowhere) << "a byte-order mark";
  EXPECT_EQ(find_bare_non_ascii(""), nowhere);
  EXPECT_EQ(find_bare_non_ascii("a = \"\\"), nowhere);
}

TEST(TomlText, WithACharacterThatIsNotAsciiOutsideQuotesIsRefusedWithItsLine) {
  for (const std::string& letter : letters) {
    const std::string message =
        error_of([&] { read_recipe("seed = 1\nload = 4" + letter, "r.toml"); }, ErrorKind::usage);
    EXPECT_NE(message.find("r.toml:2"), std::string::npos) << message;
    EXPECT_NE(message.find("in quotes"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace craze
