// What a person at a terminal sees and can do: progress, colours, Ctrl-C, full disks, closed pipes.
#include <pty.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "app/command.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/mesh/validate.h"
#include "craze/read_mesh.h"

namespace craze {
namespace {

namespace fs = std::filesystem;
class Terminal : public CommandTest {
 protected:
  /// What the command writes to a terminal as its standard error.
  std::string on_terminal(const Arguments& arguments, const char* no_color = nullptr) {
    int master = -1, slave = -1;
    if (openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) return "no terminal";
    const pid_t process = fork();
    if (process == 0) {
      if (no_color) setenv("NO_COLOR", no_color, 1);
      std::vector<char*> argv{const_cast<char*>(CRAZE_COMMAND)};
      for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
      argv.push_back(nullptr);
      const int nothing = open("/dev/null", O_RDWR);
      if (chdir((folder_ / "run").c_str()) != 0 || dup2(nothing, 1) < 0 || dup2(slave, 2) < 0) {
        _exit(99);
      }
      close(master);
      close(slave);
      execv(CRAZE_COMMAND, argv.data());
      _exit(98);
    }
    close(slave);
    std::string text;
    char buffer[4096];
    for (ssize_t got = 0; (got = read(master, buffer, sizeof buffer)) > 0;) {
      text.append(buffer, static_cast<std::size_t>(got));
    }
    close(master);
    waitpid(process, nullptr, 0);
    return text;
  }

  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / "run")) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  /// Sends the signal to a run that is still cracking, and expects it to write all of it.
  void expect_stops_cleanly(int signal, int code) {
    const pid_t process = start(with(
        long_run, {"-o", "a.ply", "--lines", "l.json", "--report", "r.json", "--fields", "f.ply"}));
    std::this_thread::sleep_for(std::chrono::milliseconds(900));
    kill(process, signal);
    const CommandResult result = finish(process);
    EXPECT_EQ(result.code, code);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(files(), (std::set<std::string>{"a.ply", "f.ply", "l.json", "r.json"}));
    const auto report = nlohmann::json::parse(read_text(file("r.json")));
    EXPECT_EQ(report["stop_reason"], "cancelled");
    const SurfaceMesh mesh = read_mesh_file(file("a.ply")).mesh,
                      fields = read_mesh_file(file("f.ply")).mesh;
    EXPECT_EQ(report["output"]["triangles"], mesh.triangles.size());
    EXPECT_EQ(fields.triangles.size(), mesh.triangles.size());
    EXPECT_TRUE(validate(TriangleMesh(mesh.positions, mesh.triangles)).empty());
    const auto lines = nlohmann::json::parse(read_text(file("l.json")));
    EXPECT_EQ(lines["edges"].empty(), report["cracks"]["segments"] == 0);
  }

  static Arguments with(Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  const Arguments short_run{
      "crack", "shape:plate?n=16&jitter=0.3", "--set",        "material.toughness=0.06",
      "--set", "evolution.shrinkage=0.05",    "--max-cracks", "20"};
  // Cracks for a minute.
  const Arguments long_run{
      "crack", "shape:plate?n=40&jitter=0.3",     "--set", "engine=euler",
      "--set", "material.toughness=0.01",         "--set", "layer.screening_length=0.1",
      "--set", "evolution.relaxation_steps=2000", "--set", "mesh.output=simulation"};
};

TEST_F(Terminal, ProgressIsOneLineThatIsUpdatedAndGoneInTheEnd) {
  const std::string text = on_terminal(with(short_run, {"-o", "a.ply"}));
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  EXPECT_EQ(text.front(), '\r');
  for (const char* phase : {"load", "prepare", "crack", "write"}) {
    EXPECT_NE(text.find(std::string("\r") + phase), std::string::npos) << phase;
  }
  EXPECT_NE(text.find("triangles"), std::string::npos);
  EXPECT_NE(text.find("cracks"), std::string::npos);
  // What follows the last return is an erased line.
  EXPECT_EQ(text.substr(text.rfind('\r')), "\r\x1b[K");
}

TEST_F(Terminal, QuietShowsNothing) {
  EXPECT_EQ(on_terminal(with(short_run, {"-o", "a.ply", "--quiet"})), "");
}

TEST_F(Terminal, ErrorsAreColouredUnlessNoColorIsSet) {
  const Arguments wrong{"check", "missing.ply"};
  EXPECT_NE(on_terminal(wrong).find("\x1b[1;31mcraze: error:"), std::string::npos);
  EXPECT_EQ(on_terminal(wrong, "1").find("craze: error: "), 0u);
  // An empty value is as good as none: https://no-color.org.
  EXPECT_NE(on_terminal(wrong, "").find("\x1b[1;31m"), std::string::npos);
  EXPECT_EQ(run(wrong).err.find('\x1b'), std::string::npos) << "not a terminal";
}

TEST_F(Terminal, AFailureClearsTheProgressBeforeTheErrorLine) {
  const std::string text =
      on_terminal(with(short_run, {"-o", "a.ply", "--set", "stress.attribute=paint"}), "1");
  const std::size_t error = text.find("craze: error: ");
  ASSERT_NE(error, std::string::npos);
  EXPECT_EQ(text.substr(error - 4, 4), "\r\x1b[K");
}

TEST_F(Terminal, CtrlCInTheMidstOfCrackingWritesAConsistentState) {
  expect_stops_cleanly(SIGINT, 130);
}

TEST_F(Terminal, SigtermDoesTheSameAndExitsWith143) {
  expect_stops_cleanly(SIGTERM, 143);
}

TEST_F(Terminal, ASecondCtrlCKillsAndLeavesNothing) {
  // Whether the second one comes in the midst of a step or of writing.
  const pid_t process =
      start({"crack", "shape:plate?n=250", "-o", "a.ply", "--set", "engine=euler", "--set",
             "layer.screening_length=0.1", "--set", "material.toughness=0.001", "--set",
             "evolution.relaxation_steps=1000000"});
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  kill(process, SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  kill(process, SIGINT);
  EXPECT_EQ(finish(process).code, 128 + SIGINT);
  EXPECT_EQ(files(), std::set<std::string>{});
}

TEST_F(Terminal, AFullDiskIsOneLineWhateverIsWritten) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  for (const auto& [option, name] : {std::pair{"-o", "a.glb"},
                                     {"-o", "a.ply"},
                                     {"-o", "a.obj"},
                                     {"--lines", "l.svg"},
                                     {"--fields", "f.ply"},
                                     {"--picture", "p.png"},
                                     {"--report", "r.json"}}) {
    fs::create_symlink("/dev/full", file(name));
    std::vector<std::string> words{option, name};
    if (words[0] == "--picture") words.insert(words.end(), {"--width", "160", "--height", "120"});
    const CommandResult result = run(with(short_run, words));
    EXPECT_EQ(result.code, 1) << name;
    EXPECT_EQ(result.err.find("craze: error: "), 0u) << name;
    EXPECT_NE(result.err.find("No space left on device"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
    EXPECT_EQ(files(), std::set<std::string>{name});
    fs::remove(file(name));
  }
}

TEST_F(Terminal, AReportToAClosedPipeStillWritesTheFiles) {
  const std::string command = "cd '" + (folder_ / "run").string() + "' && (sleep 0.3; '" +
                              CRAZE_COMMAND +
                              "' crack shape:plate?n=8 -o a.ply --max-cracks 5 --report - 2> err; "
                              "echo $? > code) | true";
  FILE* pipe = popen(command.c_str(), "r");
  pclose(pipe);
  EXPECT_EQ(read_text(file("err")), "");
  EXPECT_EQ(read_text(file("code")), "1\n");
  EXPECT_FALSE(read_mesh_file(file("a.ply")).mesh.triangles.empty());
}

}  // namespace
}  // namespace craze
