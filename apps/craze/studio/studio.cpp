// craze studio: the page on this machine, for this machine.
#include <chrono>
#include <memory>
#include <thread>

#include "app.h"
#include "craze/error.h"
#include "error_line.h"
#include "interrupt.h"
#include "open_browser.h"
#include "page_folder.h"
#include "page_server.h"

namespace craze::app {

namespace {

// Always the same, since browsers keep what was done there by address.
constexpr int usual_port = 8173;

struct Options {
  int port = usual_port;
  bool no_browser = false;
};

int studio(const Options& options) {
  catch_interrupt();
  const PageServer server(page_folder(), options.port);
  const std::string address = server.address();
  if (const int code = print("The studio is at " + address + " until Ctrl-C.\n"); code != done) {
    return code;
  }
  if (!options.no_browser && !open_browser(address)) {
    print_warning(MessageStyle::line, "no browser was opened (xdg-open): it is not there");
  }
  while (!was_interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  throw Cancelled();
}

}  // namespace

void add_studio(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
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
