// The README keeps its word: its commands run, one after the other, and its links lead somewhere.

#include <algorithm>
#include <regex>

#include "app/command.h"
#include "craze/base/text/format.h"
#include "craze/job/figure_table.h"

namespace craze {
namespace {

const std::filesystem::path root = CRAZE_SOURCE_DIR;
const std::string command = "build/release/craze ";

/// The calls of the command in the README's code blocks, each as its arguments.
std::vector<std::vector<std::string>> calls() {
  std::vector<std::vector<std::string>> calls;
  std::istringstream readme(read_text(root / "README.md"));
  bool code = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.rfind("```", 0) == 0) code = !code;
    const auto at = line.find(command);
    if (!code || at == std::string::npos) continue;
    line.erase(0, at + command.size());
    line.erase(std::remove(line.begin(), line.end(), '\''), line.end());
    std::istringstream words(line);
    calls.emplace_back();
    for (std::string word; words >> word;) calls.back().push_back(word);
  }
  return calls;
}

using Readme = CommandTest;

TEST_F(Readme, EveryCommandRunsAndWritesItsFiles) {
  ASSERT_GE(calls().size(), 3u);
  for (std::vector<std::string> call : calls()) {
    const std::string text = testing::PrintToString(call);
    if (call.front() == "crack" && call.back() != "--help") {
      call.insert(call.end(), {"--max-cracks", "3"});
    }
    if (std::find(call.begin(), call.end(), "--picture") != call.end()) {
      call.insert(call.end(), {"--width", "160", "--height", "120"});
    }
    const CommandResult result = run(call);
    EXPECT_EQ(result.code, 0) << text << "\n" << result.err;
    for (std::size_t i = 0; i + 1 < call.size(); ++i) {
      const bool output = call[i] == "-o" || call[i] == "--lines" || call[i] == "--picture" ||
                          call[i] == "--report" || call[i] == "--fields";
      if (!output) continue;
      EXPECT_TRUE(std::filesystem::exists(file(call[i + 1]))) << text << ": no " << call[i + 1];
    }
  }
}

/// The arguments of a command line, single quotes taken off.
std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '\'') {
      quoted = !quoted;
    } else if (c == ' ' && !quoted) {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

using ControlsPage = CommandTest;

TEST_F(ControlsPage, EveryCommandRunsAndItsPictureIsThere) {
  std::filesystem::create_directory_symlink(root / "docs/paint", file("paint"));
  std::filesystem::create_directories(file("images/controls"));
  const std::string page = read_text(root / "docs/controls.md");
  const std::regex row(R"(!\[\]\((images/[^)]+)\).*`craze ([^`]+)`)");
  int rows = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), row), end; at != end; ++at, ++rows) {
    const std::string picture = (*at)[1];
    std::vector<std::string> call = shell_words((*at)[2]);
    call.insert(call.end(), {"--max-cracks", "0", "--width", "32", "--height", "24"});
    const CommandResult result = run(call);
    EXPECT_EQ(result.code, 0) << (*at)[2] << "\n" << result.err;
    EXPECT_TRUE(std::filesystem::exists(file(picture))) << (*at)[2] << ": no " << picture;
    EXPECT_TRUE(std::filesystem::exists(root / "docs" / picture)) << picture;
  }
  EXPECT_GT(rows, 20);
}

TEST(Gallery, ShowsEveryFigureWithItsCommand) {
  const std::string page = read_text(root / "docs/gallery.md");
  for (const Figure& figure : figure_table()) {
    EXPECT_NE(page.find(fmt::format("## Fig. {}: {}\n", figure.number, figure.name)),
              std::string::npos)
        << figure.name;
    for (const std::string_view recipe : figure.recipes) {
      EXPECT_NE(page.find(fmt::format("--recipe recipes/figures/{}.toml", recipe)),
                std::string::npos)
          << recipe;
    }
  }
}

/// A link or picture of a page, unless it leads out of the project.
void expect_links_lead_somewhere(const std::filesystem::path& page) {
  const std::string text = read_text(page);
  const std::regex link(R"(\]\(([^)#]+)(#[^)]*)?\))");
  for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
    const std::string target = (*at)[1];
    if (target.find("://") != std::string::npos) continue;
    EXPECT_TRUE(std::filesystem::exists(page.parent_path() / target)) << page << ": " << target;
  }
}

TEST(Docs, EveryLinkLeadsSomewhere) {
  for (const char* name : {"README.md", "CHANGELOG.md"}) expect_links_lead_somewhere(root / name);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") expect_links_lead_somewhere(entry.path());
  }
}

TEST(Docs, TheIndexNamesEveryPage) {
  const std::string index = read_text(root / "docs/README.md");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() != ".md" || entry.path().filename() == "README.md") continue;
    const std::string page = std::filesystem::relative(entry.path(), root / "docs");
    EXPECT_NE(index.find("](" + page + ")"), std::string::npos) << page;
  }
}

}  // namespace
}  // namespace craze
