// What a long computation is given from outside: threads, progress, cancellation.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <string_view>

namespace craze {

/// One report of a running computation.
struct Progress {
  std::string_view phase;   ///< "load", "prepare", "crack", "write", …
  double fraction = -1;     ///< 0 … 1, or negative where no end is known
  std::int64_t cracks = 0;  ///< crack events so far
  std::int64_t triangles = 0;
  double load = 0;  ///< load factor s, or simulated time
};

/// Thrown where a computation is cancelled before there is anything worth keeping.
struct Cancelled : std::exception {
  const char* what() const noexcept override { return "cancelled"; }
};

/// Passed by reference to every long call; copies share the callbacks.
struct Context {
  int threads = 0;                                ///< 0: one per core
  std::function<void(const Progress&)> progress;  ///< called from the caller's thread only
  std::function<bool()> cancelled;                ///< polled between events

  bool is_cancelled() const { return cancelled && cancelled(); }
  void throw_if_cancelled() const {
    if (is_cancelled()) throw Cancelled();
  }
  void report(const Progress& p) const {
    if (progress) progress(p);
  }
};

}  // namespace craze
