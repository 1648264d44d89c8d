// Loops on threads of our own: a pool for each handle, whose workers spin shortly between two loops
// and then sleep.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <system_error>
#include <thread>
#include <vector>

#include "craze/base/executor.h"

namespace craze {

namespace {

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#else
  std::this_thread::yield();
#endif
}

// Whether `ready` came true within the time that sleeping and waking would take.
template <class Ready>
bool spin_until(const Ready& ready) {
  using Clock = std::chrono::steady_clock;
  constexpr auto patience = std::chrono::microseconds(50);
  const Clock::time_point end = Clock::now() + patience;
  do {
    for (int i = 0; i < 32; ++i) {
      if (ready()) return true;
      pause();
    }
  } while (Clock::now() < end);
  return false;
}

// A worker takes part by adding itself to `state_` while the loop is open; the
// caller closes the loop when no task is left, and waits for those inside alone, never for one that
// sleeps.
class Pool : public Executor {
 public:
  explicit Pool(int threads) : wanted_(threads - 1) {}

  ~Pool() override {
    state_ |= stopped;
    state_.notify_all();
    for (std::thread& worker : workers_) worker.join();
  }

 private:
  void share_out(std::size_t n, const Task& task, const std::type_info&) override {
    start_workers(n - 1);
    task_ = &task;
    end_ = n;
    next_ = 0;
    ended_ = 0;
    state_ += loop_step + is_open;  // nobody is inside
    wake(n - 1);
    work();
    const std::uint32_t last = state_.fetch_and(~is_open);
    if ((last & inside) != 0) wait_for_end();
  }

  // Fields of `state_`: workers inside, flags, and the number of the loop (which may wrap: a worker
  // that sleeps so long misses a loop).
  static constexpr std::uint32_t inside = 0xffff;
  static constexpr std::uint32_t is_open = 0x10000;
  static constexpr std::uint32_t stopped = 0x20000;
  static constexpr std::uint32_t loop_step = 0x40000;
  static std::uint32_t loop_of(std::uint32_t state) { return state / loop_step; }

  void start_workers(std::size_t useful) {
    while (workers_.size() < std::min(useful, wanted_)) {
      try {
        workers_.emplace_back([this] { serve(); });
      } catch (const std::system_error&) {  // the system gives no more: fewer do
        wanted_ = workers_.size();
      }
    }
  }

  void wake(std::size_t useful) {
    if (useful >= workers_.size()) {
      state_.notify_all();
    } else {
      for (std::size_t i = 0; i < useful; ++i) state_.notify_one();
    }
  }

  void work() {
    for (std::size_t i = next_++; i < end_; i = next_++) (*task_)(i);
  }

  // A worker's life.
  void serve() {
    std::uint32_t done = 0;  // the last loop taken part in
    for (;;) {
      std::uint32_t state = state_;
      const auto is_called = [&] {
        state = state_.load(std::memory_order_acquire);
        return (state & stopped) != 0 || ((state & is_open) != 0 && loop_of(state) != done);
      };
      if (!spin_until(is_called)) {
        state_.wait(state);
        continue;
      }
      if ((state & stopped) != 0) return;
      if (!state_.compare_exchange_strong(state, state + 1)) continue;
      done = loop_of(state);
      work();
      const std::uint32_t left = --state_;
      if ((left & (inside | is_open)) == 0) {
        ended_ = 1;
        ended_.notify_one();
      }
    }
  }

  void wait_for_end() {
    if (!spin_until([&] { return ended_ != 0; })) ended_.wait(0);
  }

  std::size_t wanted_;
  std::vector<std::thread> workers_;
  const Task* task_ = nullptr;
  std::size_t end_ = 0;
  alignas(64) std::atomic<std::size_t> next_{0};
  alignas(64) std::atomic<std::uint32_t> state_{0};
  alignas(64) std::atomic<std::uint32_t> ended_{0};  // 1: the last worker has left a closed loop
};

}  // namespace

std::shared_ptr<Executor> make_executor(int threads) {
  return std::make_shared<Pool>(threads);
}

}  // namespace craze
