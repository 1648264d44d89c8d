// craze studio: the page on this machine, for this machine, by a program of its own.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

#include "app.h"
#include "craze/error.h"

namespace craze::app {

namespace {

namespace fs = std::filesystem;

// Always the same, since browsers keep what was done there by address.
constexpr int usual_port = 8173;

struct StudioArguments {
  int port = usual_port;
  bool no_browser = false;
};

/// Where what serves the page lies: as installed; else as built.
fs::path server() {
  std::error_code none;
  const fs::path here = fs::read_symlink("/proc/self/exe", none).parent_path();
  const fs::path installed = (here / CRAZE_STUDIO_FROM_COMMAND).lexically_normal();
  if (fs::exists(installed, none)) return installed;
  return here / "libexec/craze/craze-studio";
}

/// Goes on as that program, and returns only where it cannot.
int studio(const StudioArguments& options) {
  const std::string program = server().string(), port = std::to_string(options.port);
  execl(program.c_str(), program.c_str(), "--port", port.c_str(),
        options.no_browser ? "--no-browser" : nullptr, nullptr);
  throw Error(ErrorKind::request, "cannot serve the page", program, std::strerror(errno));
}

}  // namespace

void add_studio(CLI::App& app, Action& action) {
  const auto options = std::make_shared<StudioArguments>();
  CLI::App* verb = app.add_subcommand("studio", "Crack and paint in the browser");
  verb->add_option("--port", options->port, "Port to serve the page at; 0: any that is free")
      ->type_name("N")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  verb->add_flag("--no-browser", options->no_browser, "Open no browser, say the address alone");
  verb->footer(
      "Examples:\n"
      "  craze studio\n"
      "  craze studio --port 0 --no-browser\n"
      "The page is served to this machine alone, and nothing leaves it. Ctrl-C ends it. The "
      "browser keeps what was done there, by port.");
  verb->callback([options, &action] { action = [options] { return studio(*options); }; });
}

}  // namespace craze::app
