// What a long computation is given from outside: threads, progress, cancellation.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <string_view>

#include "craze/error.h"
#include "craze/threads.h"

namespace craze {

/// One report of a running computation.
struct Progress {
  std::string_view phase;   ///< "load", "prepare", "crack", "write", …
  double fraction = -1;     ///< 0 … 1, or negative where no end is known
  std::int64_t cracks = 0;  ///< crack events so far
  std::int64_t triangles = 0;
  double load = 0;  ///< load factor s, or simulated time
};

/// Passed by reference to every long call; copies share the callbacks and the threads. Both
/// callbacks are called from the caller's thread only, never inside a parallel loop.
struct Context {
  Threads threads;                                ///< default: one per core
  std::function<void(const Progress&)> progress;  ///< what has been reached, from time to time
  std::function<bool()> cancelled;                ///< polled between events

  bool is_cancelled() const { return cancelled && cancelled(); }
  /// For work of which no part is worth keeping: throws Cancelled.
  void check() const {
    if (is_cancelled()) throw Cancelled();
  }
  void report(const Progress& p) const {
    if (progress) progress(p);
  }
};

}  // namespace craze
