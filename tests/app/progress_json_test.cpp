// --progress json: what another program reads on standard error.
#include <nlohmann/json.hpp>
#include <set>

#include "app/command.h"

namespace craze {
namespace {

class ProgressJson : public CommandTest {
 protected:
  static std::vector<nlohmann::json> lines(const std::string& text) {
    std::vector<nlohmann::json> parsed;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      parsed.push_back(nlohmann::json::parse(line));
    }
    return parsed;
  }

  static std::set<std::string> keys(const nlohmann::json& object) {
    std::set<std::string> names;
    for (const auto& [name, value] : object.items()) names.insert(name);
    return names;
  }

  const Arguments cracking{"crack", "shape:plate?n=30&jitter=0.3", "--preset",   "mud",
                           "--set", "layer.relative_spacing=0.1",  "--progress", "json"};
};

TEST_F(ProgressJson, IsOneObjectALineWithEveryPhase) {
  const CommandResult result =
      run(cracking + Arguments{"-o", "a.ply", "--picture", "p.png", "--samples", "1"});
  ASSERT_EQ(result.code, 0) << result.err;
  std::vector<std::string> phases;
  std::int64_t cracks = 0;
  for (const nlohmann::json& line : lines(result.err)) {
    ASSERT_EQ(keys(line), (std::set<std::string>{"phase", "fraction", "cracks", "load"})) << line;
    const std::string phase = line["phase"];
    if (phases.empty() || phases.back() != phase) phases.push_back(phase);
    if (!line["fraction"].is_null()) {
      EXPECT_GE(line["fraction"], 0.0);
      EXPECT_LE(line["fraction"], 1.0);
    }
    if (phase == "crack") cracks = line["cracks"];
    EXPECT_GE(line["load"], 0.0);
  }
  EXPECT_GT(cracks, 0) << "the last state of the phase";
  for (const char* phase : {"load", "repair", "remesh", "prepare", "crack", "write", "picture"}) {
    EXPECT_NE(std::find(phases.begin(), phases.end(), phase), phases.end()) << phase;
  }
}

TEST_F(ProgressJson, SaysTheLastStateOfCrackingAsTheReportDoes) {
  const CommandResult result = run(cracking + Arguments{"--report", "-"});
  ASSERT_EQ(result.code, 0) << result.err;
  nlohmann::json last;
  for (const nlohmann::json& line : lines(result.err)) {
    if (line["phase"] == "crack") last = line;
  }
  EXPECT_EQ(last["cracks"], nlohmann::json::parse(result.out)["cracks"]["events"]);
}

TEST_F(ProgressJson, ComesAboutTenTimesASecond) {
  const CommandResult result = run({"crack", "shape:plate?n=4", "--max-cracks", "0", "--frames",
                                    "f", "--frame-count", "600", "--width", "40", "--height", "30",
                                    "--samples", "1", "--progress", "json", "--report", "-"});
  ASSERT_EQ(result.code, 0) << result.err;
  const double seconds = nlohmann::json::parse(result.out)["time"]["total"];
  EXPECT_LT(static_cast<double>(lines(result.err).size()), 25 + 10 * seconds);
}

TEST_F(ProgressJson, HasWarningsAndErrorsAsObjectsToo) {
  const Arguments unstressed{"crack", "shape:plate?n=4",  "-o",         "a.ply",
                             "--set", "stress.uniform=0", "--progress", "json"};
  const CommandResult warned = run(unstressed);
  EXPECT_EQ(warned.code, 0);
  EXPECT_EQ(keys(lines(warned.err).back()), std::set<std::string>{"warning"});
  EXPECT_EQ(lines(run(unstressed + Arguments{"--quiet"}).err).size(), 1u);
  EXPECT_EQ(run(unstressed + Arguments{"--quiet", "--no-warnings"}).err, "");

  for (const auto& [arguments, code] :
       {std::pair{Arguments{"crack", "missing\xff.obj", "-o", "a.ply", "--progress", "json"}, 1},
        {Arguments{"render", "missing.obj", "-o", "a.png", "--progress=json"}, 1},
        {Arguments{"crack", "shape:plate", "--progress", "json", "--frobnicate"}, 2},
        {Arguments{"figures", "nothing", "-o", "f", "--progress", "json"}, 2}}) {
    const CommandResult wrong = run(arguments);
    EXPECT_EQ(wrong.code, code) << wrong.err;
    ASSERT_FALSE(lines(wrong.err).empty());
    EXPECT_EQ(keys(lines(wrong.err).back()), std::set<std::string>{"error"}) << wrong.err;
  }
}

TEST_F(ProgressJson, ClosedPipesEndNoRun) {
  const std::string command = "cd '" + (folder_ / "run").string() + "' && ((sleep 0.3; '" +
                              CRAZE_COMMAND +
                              "' crack shape:plate?n=8 -o a.ply --max-cracks 5 --progress json; "
                              "echo $? > code) 2>&1) | true";
  FILE* pipe = popen(command.c_str(), "r");
  pclose(pipe);
  EXPECT_EQ(read_text(file("code")), "0\n");
  EXPECT_TRUE(std::filesystem::exists(file("a.ply")));
}

}  // namespace
}  // namespace craze
