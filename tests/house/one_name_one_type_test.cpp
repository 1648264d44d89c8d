// Two types of one name in one namespace make the program's meaning undefined, and neither compiler
// nor linker says so.
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "source_tree.h"

namespace craze::house {
namespace {

/// Types that a header defines outside other types, with their namespace: "craze::Threads".
std::vector<std::string> types_of(const std::filesystem::path& header) {
  static const std::regex space("^namespace ([A-Za-z_:]+) \\{");
  static const std::regex type(
      "^(?:struct|class|union|enum class|enum) (?:alignas\\(\\w+\\) |\\[\\[.*\\]\\] "
      ")?([\\w:]+)[^;]*$");
  std::vector<std::string> types;
  std::string inside;
  std::istringstream lines(read_text(header));
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_search(line, match, space)) inside = match[1];
    if (std::regex_match(line, match, type)) types.push_back(inside + "::" + match[1].str());
  }
  return types;
}

TEST(Types, HaveANameOfTheirOwn) {
  std::map<std::string, std::filesystem::path> defined;
  for (const std::string folder : {"include", "src/craze", "apps"}) {
    for (const auto& source : sources_below(folder)) {
      if (source.extension() != ".h") continue;
      for (const std::string& type : types_of(source)) {
        const auto [other, is_new] = defined.emplace(type, source);
        EXPECT_TRUE(is_new) << type << " is defined in " << other->second << " and in " << source;
      }
    }
  }
  EXPECT_GT(defined.size(), 200u) << "the definitions were not found";
}

}  // namespace
}  // namespace craze::house
