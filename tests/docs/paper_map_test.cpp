// docs/paper/equations.md names what exists, and leaves nothing of the paper out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = CRAZE_SOURCE_DIR;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Row {
  std::string label;
  std::vector<std::string> files, functions, tests;
};

std::string trimmed(const std::string& s) {
  const auto begin = s.find_first_not_of(' '), end = s.find_last_not_of(' ');
  return begin == std::string::npos ? "" : s.substr(begin, end - begin + 1);
}

/// The words between backticks.
std::vector<std::string> names_in(const std::string& cell) {
  std::vector<std::string> names;
  for (std::size_t at = cell.find('`'); at != std::string::npos; at = cell.find('`', at)) {
    const std::size_t end = cell.find('`', at + 1);
    if (end == std::string::npos) break;
    names.push_back(cell.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return names;
}

std::vector<Row> rows() {
  std::vector<Row> rows;
  std::ifstream in(root / "docs/paper/equations.md");
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] != '|') continue;
    std::vector<std::string> cells;
    for (std::size_t at = 1; at < line.size();) {
      const std::size_t end = std::min(line.find('|', at), line.size());
      cells.push_back(trimmed(line.substr(at, end - at)));
      at = end + 1;
    }
    if (cells.size() != 5) {
      ADD_FAILURE() << "not five cells: " << line;
      continue;
    }
    if (cells[0] == "Paper" || cells[0].rfind("---", 0) == 0) continue;
    rows.push_back({cells[0], names_in(cells[2]), names_in(cells[3]), names_in(cells[4])});
  }
  return rows;
}

/// All tests as "Suite.Name".
std::set<std::string> all_tests() {
  std::set<std::string> tests;
  for (const auto& entry : fs::recursive_directory_iterator(root / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = text_of(entry.path());
    for (const std::string macro : {"TEST(", "TEST_F(", "TEST_P(", "RC_GTEST_PROP("}) {
      for (std::size_t at = text.find(macro); at != std::string::npos; at = text.find(macro, at)) {
        at += macro.size();
        std::string name;  // "Suite,Name" without white space, up to the second comma or bracket
        int commas = 0;
        for (; at < text.size() && text[at] != ')'; ++at) {
          if (text[at] == ',' && ++commas == 2) break;
          if (!std::isspace(static_cast<unsigned char>(text[at]))) name += text[at];
        }
        std::replace(name.begin(), name.end(), ',', '.');
        tests.insert(name);
      }
    }
  }
  return tests;
}

/// Whether `name` stands in the text as a whole word with an opening bracket after it.
bool has_function(const std::string& text, const std::string& name) {
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  for (std::size_t at = text.find(name + "("); at != std::string::npos;
       at = text.find(name + "(", at + 1)) {
    if (at == 0 || !in_word(text[at - 1])) return true;
  }
  return false;
}

TEST(PaperMap, NamesFilesAndFunctionsThatExist) {
  for (const Row& row : rows()) {
    EXPECT_FALSE(row.files.empty()) << row.label;
    EXPECT_FALSE(row.functions.empty()) << row.label;
    std::string text;
    for (const std::string& file : row.files) {
      EXPECT_TRUE(fs::is_regular_file(root / file)) << row.label << ": " << file;
      text += text_of(root / file);
    }
    for (const std::string& function : row.functions) {
      EXPECT_TRUE(has_function(text, function)) << row.label << ": " << function;
    }
  }
}

TEST(PaperMap, NamesTestsThatExist) {
  const std::set<std::string> tests = all_tests();
  EXPECT_TRUE(tests.count("PaperMap.NamesTestsThatExist"));
  for (const Row& row : rows()) {
    EXPECT_FALSE(row.tests.empty()) << row.label;
    for (const std::string& test : row.tests) {
      EXPECT_TRUE(tests.count(test)) << row.label << ": " << test;
    }
  }
}

TEST(PaperMap, LeavesNothingOfThePaperOut) {
  std::multiset<std::string> labels;
  for (const Row& row : rows()) labels.insert(row.label);
  for (int i = 1; i <= 9; ++i) EXPECT_EQ(labels.count("Eq. " + std::to_string(i)), 1u) << i;
  for (int i = 1; i <= 12; ++i) EXPECT_EQ(labels.count("Fig. " + std::to_string(i)), 1u) << i;
  for (const std::string step : {"1", "2", "3", "3a", "3b.i", "3b.ii", "3c", "4"}) {
    EXPECT_EQ(labels.count("Step " + step), 1u) << step;
  }
}

/// Every deviation is told in three parts.
TEST(Interpretations, SayWhatThePaperSaysWhatWeDoAndWhy) {
  const std::string text = text_of(root / "docs/paper/interpretations.md");
  int says = 0, does = 0, why = 0, headings = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    headings += line.rfind("### ", 0) == 0;
    says += line.rfind("- **Paper says:**", 0) == 0;
    does += line.rfind("- **We do:**", 0) == 0;
    why += line.rfind("- **Why:**", 0) == 0;
    at = end + 1;
  }
  EXPECT_GT(headings, 15);
  EXPECT_EQ(says, headings);
  EXPECT_EQ(does, headings);
  EXPECT_EQ(why, headings);
}

}  // namespace
