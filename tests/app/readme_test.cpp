// The README keeps its word: its commands run, one after the other, and its links lead somewhere.
#include <algorithm>
#include <regex>

#include "app/command.h"

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
