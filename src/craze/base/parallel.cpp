#include "craze/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>
#include <mutex>

#include "craze/base/executor.h"

namespace craze {

void parallel_for(const Threads& threads, std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body,
                  const std::type_info* name) {
  assert(grain > 0);
  const std::size_t chunks = n / grain + (n % grain != 0 ? 1 : 0);
  const auto run_chunk = [&](std::size_t c) { body(c * grain, std::min(n, (c + 1) * grain)); };
  if (!threads.executor()) {
    for (std::size_t c = 0; c < chunks; ++c) run_chunk(c);
    return;
  }
  if (chunks == 0) return;
  // Chunks before a failed one still run, so that the first failure is found whatever the order.
  std::atomic<std::size_t> failed{chunks};
  std::exception_ptr error;
  std::mutex error_mutex;
  const auto try_chunk = [&](std::size_t c) {
    if (c > failed.load(std::memory_order_relaxed)) return;
    try {
      run_chunk(c);
    } catch (...) {
      const std::lock_guard lock(error_mutex);
      if (c > failed) return;
      failed = c;
      error = std::current_exception();
    }
  };
  threads.executor()->run(chunks, std::ref(try_chunk), name ? *name : body.target_type());
  if (error) std::rethrow_exception(error);
}

}  // namespace craze
