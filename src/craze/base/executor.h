// What runs tasks side by side: oneTBB or threads of our own, whichever is built in (CRAZE_TBB).
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

namespace craze {

class Executor {
 public:
  using Task = std::function<void(std::size_t)>;

  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// Calls task(i) once for each i in [0, n), n > 0, in any order, in the calling thread and in
  /// others, and returns when all calls have. The task must not throw. A call that comes while
  /// another runs (from inside it, or from another thread) stays in its own thread, so that nobody
  /// ever waits for a loop that is not his.
  void run(std::size_t n, const Task& task) {
    if (busy_.exchange(true, std::memory_order_acquire)) {
      for (std::size_t i = 0; i < n; ++i) task(i);
      return;
    }
    share_out(n, task);
    busy_.store(false, std::memory_order_release);
  }

 private:
  virtual void share_out(std::size_t n, const Task& task) = 0;

  std::atomic<bool> busy_{false};
};

/// For `threads` > 1 threads, the caller's included. Starts none yet.
std::shared_ptr<Executor> make_executor(int threads);

}  // namespace craze
