#include "craze/recipe/toml_text.h"

#include <gtest/gtest.h>

#include <string>

#include "craze/recipe.h"
#include "error_message.h"

namespace craze {
namespace {

constexpr std::size_t nowhere = std::string::npos;

std::size_t fault_of(const std::string& toml) {
  const auto fault = find_toml_fault(toml);
  return fault ? fault->at : nowhere;
}

// Characters that the TOML library's test for white space has no answer for, and some that it has.
const std::string letters[] = {"µ", "é", "\u1472", "\u1C80", "中", "\uFEFF", "😀", "\xFF"};

TEST(TomlText, KnowsWhereACharacterStandsThatIsNotAscii) {
  for (const std::string& letter : letters) {
    EXPECT_EQ(fault_of("a = 4" + letter), 5u) << letter;
    EXPECT_EQ(fault_of(letter == "\uFEFF" ? " " + letter : letter + " = 1"),
              letter == "\uFEFF" ? 1u : 0u);
    EXPECT_EQ(fault_of("a = \"x\"\nb = 'y'" + letter), 15u) << letter;
    EXPECT_EQ(fault_of("a = \"\"\"x\"\n\"y\"\"\"" + letter), 15u) << letter;
    EXPECT_EQ(fault_of("a = \"\"\"x\"\"\"\"\"" + letter), 13u) << "x and two quotes";
    EXPECT_EQ(fault_of("a = \"x\n" + letter), 7u) << "a string ends with its line";
    for (const std::string quote : {"\"", "'", "\"\"\"", "'''"}) {
      EXPECT_EQ(fault_of("a = " + quote + letter + quote + " # " + letter), nowhere);
      EXPECT_EQ(fault_of("a = " + quote + letter), nowhere) << "not closed";
    }
    EXPECT_EQ(fault_of("a = \"\\\"" + letter + "\""), nowhere) << "an escaped quote";
    EXPECT_EQ(fault_of("a = '\\' # " + letter), nowhere) << "no escapes in '";
    EXPECT_EQ(fault_of("# \"\n# " + letter), nowhere) << "a quote in a comment";
  }
  EXPECT_EQ(fault_of("\uFEFFa = 1"), nowhere) << "a byte-order mark";
  EXPECT_EQ(fault_of(""), nowhere);
  EXPECT_EQ(fault_of("a = \"\\"), nowhere);
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

TEST(TomlText, WithAHeaderThatDoesNotBeginWithAKeyIsRefusedWithItsLine) {
  for (const std::string after :
       {"= 2", "= 2]", ".a]", "+1]", ",", "#", "\n", "\r\n", "!", "{}]"}) {
    for (const std::string begin : {"[", "[[", "[ \t", "[[ ", "  ["}) {
      const std::string text = "seed = 1\n" + begin + after;
      EXPECT_EQ(fault_of(text), text.size() - after.size()) << text;
      const std::string message = error_of([&] { read_recipe(text, "r.toml"); }, ErrorKind::usage);
      EXPECT_NE(message.find("r.toml:2"), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
  for (const std::string text :
       {"[a]\n[b.c]\n[[d]]\n", "[\"a\"]", "['a b']", "[-]", "[_]", "[", "[[", "[ ", "[]",
        "a = [\n[+1, .5],\n[1,\n2]\n]\n[b]", "a = '''\n[=\n'''", "a = 1 # \n# [=\n"}) {
    EXPECT_EQ(fault_of(text), nowhere) << text;
  }
  EXPECT_EQ(fault_of("a = [\n[1]\n]\n[=]"), 13u) << "after an array";
  EXPECT_EQ(fault_of("[a]\nb = ']'\n[=]"), 13u) << "a bracket in quotes";
}

}  // namespace
}  // namespace craze
