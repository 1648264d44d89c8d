#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "house/source_tree.h"

namespace craze::house {
namespace {

/// Lines of a source without what follows "//", numbered from 1.
std::vector<std::string> code_lines(const std::filesystem::path& source) {
  std::vector<std::string> result;
  std::istringstream lines(read_text(source));
  for (std::string line; std::getline(lines, line);)
    result.push_back(line.substr(0, line.find("//")));
  return result;
}

/// Whether a line calls a function that each mathematical library rounds its own way: not one of
/// elementary.h's, and not one of those that are exact (sqrt, floor, ldexp, fmod, …).
bool calls_library_function(const std::string& line) {
  static const std::regex call(
      R"((elementary::)?\b(exp|exp2|expm1|log|log2|log10|log1p|sin|cos|tan|sincos|asin|acos|atan|)"
      R"(atan2|sinh|cosh|tanh|asinh|acosh|atanh|pow|hypot|cbrt|erf|erfc|tgamma|lgamma|fma)[fl]?\()");
  for (std::sregex_iterator i(line.begin(), line.end(), call), end; i != end; ++i) {
    if (!(*i)[1].matched) return true;
  }
  return false;
}

void expect_in_no_line(bool (*is_bad)(const std::string&), const std::string& why) {
  for (const std::string folder : {"src/craze", "apps"}) {
    for (const auto& source : sources_below(folder)) {
      if (source.filename().string().rfind("elementary", 0) == 0) continue;
      const std::vector<std::string> lines = code_lines(source);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        EXPECT_FALSE(is_bad(lines[i])) << source << ":" << i + 1 << ": " << why << "\n" << lines[i];
      }
    }
  }
}

TEST(SameBytes, ElementaryFunctionsAreOurOwn) {
  EXPECT_TRUE(calls_library_function("y = std::exp(x);"));
  EXPECT_TRUE(calls_library_function("y = 2*cosf(x);"));
  EXPECT_TRUE(calls_library_function("y = a.array().pow(3);"));
  EXPECT_FALSE(calls_library_function("y = elementary::exp(x) + std::sqrt(x);"));
  expect_in_no_line(&calls_library_function, "differs between libraries: see base/elementary.h");
}

// Their results, or the order of their sums, are the standard library's own choice.
bool leaves_choice_to_the_library(const std::string& line) {
  static const std::regex word(
      R"(#include <random>|std::(reduce|transform_reduce|shuffle|sample|hash)\b|\blong double\b)");
  return std::regex_search(line, word);
}

TEST(SameBytes, NothingIsLeftToTheStandardLibrarysChoice) {
  EXPECT_TRUE(leaves_choice_to_the_library("const double s = std::reduce(a.begin(), a.end());"));
  EXPECT_FALSE(leaves_choice_to_the_library("const double s = std::accumulate(a, b, 0.0);"));
  expect_in_no_line(&leaves_choice_to_the_library, "differs between standard libraries");
}

}  // namespace
}  // namespace craze::house
