// What runs tasks side by side: oneTBB or threads of our own, whichever is built in (CRAZE_TBB); or
// what times them (CRAZE_WORK_AND_SPAN).
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <typeinfo>

namespace craze {

class Executor {
 public:
  using Task = std::function<void(std::size_t)>;

  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// Calls task(i) once for each i in [0, n), n > 0, in any order, in the calling thread and in
  /// others, and returns when all calls have. The task must not throw. `body` is the type of what
  /// the tasks are parts of, by which loops are told apart. A call that comes while
  /// another runs (from inside it, or from another thread) stays in its own thread, so that nobody
  /// ever waits for a loop that is not his.
  void run(std::size_t n, const Task& task, const std::type_info& body) {
    if (n == 1) {
      alone(task, body);
      return;
    }
    if (busy_.exchange(true, std::memory_order_acquire)) {
      for (std::size_t i = 0; i < n; ++i) task(i);
      return;
    }
    share_out(n, task, body);
    busy_.store(false, std::memory_order_release);
  }

 private:
  /// Calls task(0), which may run loops of its own.
  virtual void alone(const Task& task, const std::type_info&) { task(0); }
  virtual void share_out(std::size_t n, const Task& task, const std::type_info& body) = 0;

  std::atomic<bool> busy_{false};
};

/// For `threads` > 1 threads, the caller's included. Starts none yet.
std::shared_ptr<Executor> make_executor(int threads);

}  // namespace craze
