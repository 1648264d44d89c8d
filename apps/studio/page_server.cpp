#include "page_server.h"

#include <httplib.h>
#include <sys/socket.h>

#include <atomic>
#include <thread>

#include "craze/error.h"

namespace craze::app {

namespace {

constexpr const char* loopback = "127.0.0.1";

}  // namespace

struct PageServer::State {
  httplib::Server server;
  int port = 0;
  std::atomic<bool> ended = false;  ///< the thread listens no longer, or never did
  std::thread thread;
};

PageServer::PageServer(const std::filesystem::path& folder, int port)
    : state_(std::make_unique<State>()) {
  httplib::Server& server = state_->server;
  // The library's own would let two servers have one port.
  server.set_socket_options([](int socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.set_tcp_nodelay(true);
  server.set_keep_alive_timeout(1);  // seconds that stop() waits for browsers that are still there
  server.set_file_extension_and_mimetype_mapping("js", "text/javascript");
  server.set_file_extension_and_mimetype_mapping("webmanifest", "application/manifest+json");
  server.set_mount_point("/", folder.string(),
                         {{"Cache-Control", "no-cache"}, {"X-Content-Type-Options", "nosniff"}});
  state_->port = port == 0                             ? server.bind_to_any_port(loopback)
                 : server.bind_to_port(loopback, port) ? port
                                                       : -1;
  if (state_->port < 0) {
    throw Error(ErrorKind::request, "cannot serve the page",
                std::string(loopback) + ":" + std::to_string(port),
                "the port is taken or not allowed; give another by --port, 0 for any that is free");
  }
  state_->thread = std::thread([state = state_.get()] {
    state->server.listen_after_bind();
    state->ended = true;
  });
}

PageServer::~PageServer() {
  // stop() does nothing before the thread has come to listen, which it may never do.
  while (!state_->server.is_running() && !state_->ended) std::this_thread::yield();
  state_->server.stop();
  state_->thread.join();
}

std::string PageServer::address() const {
  return "http://" + std::string(loopback) + ":" + std::to_string(state_->port) + "/";
}

}  // namespace craze::app
