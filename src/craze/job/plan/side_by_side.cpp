#include "craze/job/plan/side_by_side.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "craze/base/parallel.h"

namespace craze {

namespace {

using Work = std::function<void(std::size_t, const Context&)>;

/// What all threads take their work from.
class Bench {
 public:
  Bench(std::size_t n, const Context& context, const Work& work)
      : n_(n), context_(context), work_(work), errors_(n) {}

  /// Takes one after the other until there is none; the caller's thread then waits for the others,
  /// asking whether to stop.
  void take_all() {
    const bool in_caller = std::this_thread::get_id() == caller_;
    const Context own{Threads(1), {}, [this, in_caller] {
                        if (in_caller && context_.is_cancelled()) stop_ = true;
                        return stop_.load();
                      }};
    for (std::size_t i = next_++; i < n_; i = next_++) take(i, own);
    if (!in_caller) return;
    constexpr auto pause = std::chrono::milliseconds(20);
    std::unique_lock lock(mutex_);
    while (!all_done_.wait_for(lock, pause, [this] { return done_ == n_; })) {
      lock.unlock();
      own.is_cancelled();
      lock.lock();
    }
  }

  void rethrow() const {
    for (const std::exception_ptr& error : errors_) {
      if (error) std::rethrow_exception(error);
    }
  }

 private:
  void take(std::size_t i, const Context& own) {
    // What comes before a failure is still done, so that the first is found whatever the order.
    try {
      if (i < failed_.load()) work_(i, own);
    } catch (...) {
      errors_[i] = std::current_exception();
      for (std::size_t first = failed_; i < first && !failed_.compare_exchange_weak(first, i);) {
      }
    }
    const std::lock_guard lock(mutex_);
    if (++done_ == n_) all_done_.notify_all();
  }

  std::size_t n_;
  const Context& context_;
  const Work& work_;
  std::vector<std::exception_ptr> errors_;
  const std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<bool> stop_{false};
  std::atomic<std::size_t> next_{0}, failed_{n_};
  std::mutex mutex_;
  std::condition_variable all_done_;
  std::size_t done_ = 0;
};

}  // namespace

void side_by_side(std::size_t n, const Context& context, const Work& work) {
  if (n == 1) {
    work(0, {context.threads, {}, context.cancelled});
    return;
  }
  Bench bench(n, context, work);
  const auto threads = static_cast<std::size_t>(std::max(1, context.threads.count()));
  parallel_for(context.threads, std::min(n, threads), 1,
               [&](std::size_t, std::size_t) { bench.take_all(); });
  bench.rethrow();
}

}  // namespace craze
