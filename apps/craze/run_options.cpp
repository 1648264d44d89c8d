#include "run_options.h"

#include "terminal/error_line.h"
#include "terminal/interrupt.h"
#include "terminal/progress_json.h"
#include "terminal/progress_line.h"

namespace craze::app {

namespace {

std::unique_ptr<ProgressView> make_view(const RunOptions& options) {
  if (options.quiet) return nullptr;
  if (options.style == MessageStyle::json) return std::make_unique<ProgressJson>();
  return std::make_unique<ProgressLine>();
}

}  // namespace

void add_run_options(CLI::App& verb, RunOptions& options, const char* quiet) {
  verb.add_option("--threads", options.threads, "0: one per core")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  verb.add_option_function<std::string>(
          "--progress",
          [&options](const std::string& style) {
            options.style = style == "json" ? MessageStyle::json : MessageStyle::line;
          },
          "line: on a terminal; json: for programs, one object a line on standard error, and "
          "warnings and errors so too")
      ->check(CLI::IsMember({"line", "json"}).description(""))
      ->type_name("STYLE")
      ->default_str("line");
  verb.add_flag("--quiet", options.quiet, quiet);
  add_warning_option(verb, options.no_warnings);
}

void add_warning_option(CLI::App& verb, bool& no_warnings) {
  verb.add_flag(
      "--no-warnings", no_warnings,
      "Do not say what was left out or could not be done as asked; reports say it all the "
      "same");
}

void print_warnings(const RunOptions& options, const std::vector<std::string>& warnings) {
  if (options.no_warnings) return;
  for (const std::string& warning : warnings) print_warning(options.style, warning);
}

Run::Run(const RunOptions& options) : view_(make_view(options)) {
  catch_interrupt();
  context_.threads = options.threads;
  context_.cancelled = was_interrupted;
  if (view_) context_.progress = [this](const Progress& progress) { view_->update(progress); };
}

}  // namespace craze::app
