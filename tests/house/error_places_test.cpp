// An error reads "WHAT (WHERE): WHY".
#include <gtest/gtest.h>

#include "source_tree.h"

namespace craze::house {
namespace {

/// The arguments of the call that begins at `at`, behind its bracket.
std::vector<std::string> arguments_at(const std::string& text, std::size_t at) {
  std::vector<std::string> arguments(1);
  bool quoted = false;
  for (int depth = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"' && text[at - 1] != '\\') quoted = !quoted;
    if (!quoted && (c == '(' || c == '{' || c == '[')) ++depth;
    if (!quoted && (c == ')' || c == '}' || c == ']') && depth-- == 0) break;
    if (!quoted && depth == 0 && c == ',') {
      arguments.emplace_back();
    } else if (quoted || (c != ' ' && c != '\n')) {
      arguments.back() += c;
    }
  }
  return arguments;
}

TEST(Errors, NameThePlace) {
  const std::string begin = "throw Error(";
  std::size_t errors = 0;
  for (const std::string folder : {"src/craze", "apps", "bindings"}) {
    for (const auto& source : sources_below(folder)) {
      const std::string text = read_text(source);
      for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
        const std::vector<std::string> arguments = arguments_at(text, at + begin.size());
        ASSERT_EQ(arguments.size(), 4u) << source << ": " << text.substr(at, 200);
        EXPECT_NE(arguments[2], "\"\"") << source << ": " << arguments[1];
        ++errors;
      }
    }
  }
  EXPECT_GT(errors, 100u) << "the errors were not found";
}

}  // namespace
}  // namespace craze::house
