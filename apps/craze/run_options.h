// What every verb that takes long can be told about how it runs, and what it runs in.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "craze/context.h"
#include "terminal/message_style.h"
#include "terminal/progress_view.h"

namespace craze::app {

struct RunOptions {
  int threads = 0;  ///< 0: one per core
  MessageStyle style = MessageStyle::line;
  bool quiet = false;
  bool no_warnings = false;
};

/// --threads, --progress, --quiet, --no-warnings; `quiet` says what --quiet leaves out.
void add_run_options(CLI::App& verb, RunOptions& options, const char* quiet = "No progress");

/// --no-warnings, for verbs without the others.
void add_warning_option(CLI::App& verb, bool& no_warnings);

/// Says each of them on standard error, unless they are not wanted.
void print_warnings(const RunOptions& options, const std::vector<std::string>& warnings);

/// A run while it lasts: its progress is shown as asked for, and from its beginning on a signal
/// stops it (interrupt.h).
class Run {
 public:
  explicit Run(const RunOptions& options);
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  const Context& context() const { return context_; }

 private:
  std::unique_ptr<ProgressView> view_;  ///< null: nothing is shown
  Context context_;
};

}  // namespace craze::app
