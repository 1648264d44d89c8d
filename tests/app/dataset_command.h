// Small sets, made by the built command.
#pragma once

#include <map>

#include "app/command.h"

namespace craze {

inline constexpr const char* small_plan = R"(
samples = 6
shard_samples = 2
clean = 0.3
width = 48
height = 40
folders = "yes"
[object]
mesh = "shape:plate?n=14&jitter=0.3"
[recipe]
preset = "mud"
layer.relative_spacing = {uniform = [0.2, 0.3]}
[lines]
width = {uniform = [1, 4]}
[image]
quality = {choice = [70, 100]}
)";

class Dataset : public CommandTest {
 protected:
  Dataset() { write("plan.toml", small_plan); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(file(name)) << text;
  }

  /// All files of a set by their names.
  std::map<std::string, std::string> bytes_of(const std::string& name) const {
    std::map<std::string, std::string> bytes;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(file(name))) {
      if (!entry.is_regular_file()) continue;
      bytes[std::filesystem::relative(entry.path(), file(name)).string()] = read_text(entry.path());
    }
    return bytes;
  }

  void make(const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"dataset", "plan.toml", "-o", name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandResult result = run(arguments);
    ASSERT_EQ(result.code, 0) << result.err;
  }
};

}  // namespace craze
