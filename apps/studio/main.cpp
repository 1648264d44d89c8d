// craze-studio --port N [--no-browser]: what `craze studio` becomes.
#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <thread>

#include "craze/context.h"
#include "open_browser.h"
#include "page_folder.h"
#include "page_server.h"
#include "terminal/error_line.h"
#include "terminal/exit_code.h"
#include "terminal/interrupt.h"
#include "terminal/print.h"
#include "terminal/standard_streams.h"

namespace {

using namespace craze::app;

int serve(int port, bool browser) {
  catch_interrupt();
  const PageServer server(page_folder(), port);
  const std::string address = server.address();
  if (const int code = print("The studio is at " + address + " until Ctrl-C.\n"); code != done) {
    return code;
  }
  if (browser && !open_browser(address)) {
    print_warning(MessageStyle::line, "no browser was opened (xdg-open): it is not there");
  }
  while (!was_interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  throw craze::Cancelled();
}

}  // namespace

int main(int argc, char** argv) {
  fill_standard_streams();
  std::signal(SIGPIPE, SIG_IGN);
  CLI::App app{"Serves the page of craze studio; craze studio --help says more.", "craze-studio"};
  int port = 0;
  bool no_browser = false;
  app.add_option("--port", port)->required()->check(CLI::Range(0, 65535));
  app.add_flag("--no-browser", no_browser);
  CLI11_PARSE(app, argc, argv);
  return exit_code_of(MessageStyle::line, [&] { return serve(port, !no_browser); });
}
