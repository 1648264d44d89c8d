// Runs the built command as a user would.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace craze {

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

using Arguments = std::vector<std::string>;

inline Arguments operator+(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

struct CommandResult {
  int code = -1;  ///< exit status
  std::string out, err;
};

/// A test with a folder of its own, in which the command runs.
class CommandTest : public testing::Test {
 protected:
  CommandTest() { std::filesystem::create_directory(folder_ / "run"); }

  std::filesystem::path file(const std::string& name) const { return folder_ / "run" / name; }

  /// Starts it and returns its process; standard output goes to `out_path` where one is given.
  pid_t start(const std::vector<std::string>& arguments, const std::string& out_path = "") {
    const std::string out = out_path.empty() ? (folder_ / "out").string() : out_path;
    const std::string err = (folder_ / "err").string();
    const pid_t process = fork();
    if (process != 0) return process;
    std::vector<char*> argv{command_.data()};
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    const int out_file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    const int err_file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (chdir((folder_ / "run").c_str()) != 0 || dup2(out_file, 1) < 0 || dup2(err_file, 2) < 0) {
      _exit(99);
    }
    execv(command_.c_str(), argv.data());
    _exit(98);
  }

  CommandResult finish(pid_t process) {
    int status = 0;
    waitpid(process, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            read_text(folder_ / "out"), read_text(folder_ / "err")};
  }

  CommandResult run(const std::vector<std::string>& arguments) { return finish(start(arguments)); }

  /// Expects the exit code and one error line that holds `words`, and nothing left in the folder.
  void expect_error(const std::vector<std::string>& arguments, int code, const std::string& words) {
    const CommandResult result = run(arguments);
    EXPECT_EQ(result.code, code) << result.err;
    EXPECT_EQ(result.err.find("craze: error: "), 0u) << result.err;
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / "run"));
  }

  TemporaryFolder folder_;
  std::string command_ = CRAZE_COMMAND;
};

}  // namespace craze
