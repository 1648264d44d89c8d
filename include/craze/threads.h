// How many threads a computation may use, and the handle that owns them.
#pragma once

#include <memory>

namespace craze {

class Executor;

/// A number of threads, and the threads themselves: copies share them, the first loop of several
/// chunks starts them, the last copy ends them. Two handles share nothing. Any number of threads
/// may use one handle, at the same time too.
class Threads {
 public:
  static constexpr int max_count = 1024;

  /// count = 0: one per core; 1 (or less than 0): the caller's thread alone, nothing is started;
  /// above max_count: max_count.
  Threads(int count = 0);  // NOLINT(google-explicit-constructor): a number says it all

  /// The threads that a loop may use, the caller's included: 1 … max_count.
  int count() const { return count_; }
  /// What runs the loops; null where count() is 1.
  Executor* executor() const { return executor_.get(); }

 private:
  int count_;
  std::shared_ptr<Executor> executor_;
};

}  // namespace craze
