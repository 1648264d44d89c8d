// Options that do nothing alone.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace craze::app {

/// Options that change nothing unless something else is asked for.
struct OptionNeed {
  std::vector<std::string> options;  ///< "--stain"
  std::string needed;                ///< what to give, as the user is told: "--as maps"
  std::function<bool()> is_asked;    ///< whether that is asked for
};

/// Throws Error(usage) for the first given option whose need is not met. To be called when the
/// whole command line is read.
void check_needs(const CLI::App& verb, const std::vector<OptionNeed>& needs);

/// The verb's options of these groups.
std::vector<std::string> options_of_groups(const CLI::App& verb,
                                           const std::vector<std::string>& groups);

}  // namespace craze::app
