// The files of a folder, to this machine alone.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace craze::app {

/// Serves from when it is made until it is destroyed, by threads of its own. Nothing is written,
/// and no other machine can ask: it listens at 127.0.0.1.
class PageServer {
 public:
  /// `port` 0: any that is free. Throws Error(request) where the port cannot be had.
  PageServer(const std::filesystem::path& folder, int port);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// "http://127.0.0.1:8173/"
  std::string address() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace craze::app
