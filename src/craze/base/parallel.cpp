#include "craze/base/parallel.h"

#include <algorithm>

#ifndef __EMSCRIPTEN__
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif
#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <exception>
#include <thread>
#include <vector>
#endif

namespace craze {

int thread_count(int threads) {
#ifndef __EMSCRIPTEN__
  if (threads == 0) return std::max(1, tbb::this_task_arena::max_concurrency());
#endif
  return std::max(1, threads);
}

#ifdef __SANITIZE_THREAD__
namespace {

// TBB's library is not compiled for ThreadSanitizer, which would see none of its order: here
// threads of the standard library take the same chunks.
template <class RunChunk>
void run_on_seen_threads(int threads, std::size_t chunks, const RunChunk& run_chunk) {
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> errors(threads);
  const auto work = [&](int thread) {
    try {
      for (std::size_t c = next++; c < chunks; c = next++) run_chunk(c);
    } catch (...) {
      errors[thread] = std::current_exception();
    }
  };
  std::vector<std::thread> helpers;
  for (int i = 1; i < threads; ++i) helpers.emplace_back(work, i);
  work(0);
  for (std::thread& helper : helpers) helper.join();
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace
#endif

void parallel_for(int threads, std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t chunks = (n + grain - 1) / grain;
  const auto run_chunk = [&](std::size_t c) { body(c * grain, std::min(n, (c + 1) * grain)); };
#ifndef __EMSCRIPTEN__
  if (threads != 1 && chunks > 1) {
#ifdef __SANITIZE_THREAD__
    run_on_seen_threads(thread_count(threads), chunks, run_chunk);
#else
    const auto loop = [&] { tbb::parallel_for(std::size_t{0}, chunks, run_chunk); };
    // An arena of its own costs more than most loops: only where fewer threads are asked for.
    if (threads == 0 || threads >= tbb::this_task_arena::max_concurrency()) {
      loop();
    } else {
      tbb::task_arena(threads).execute(loop);
    }
#endif
    return;
  }
#endif
  for (std::size_t c = 0; c < chunks; ++c) run_chunk(c);
}

}  // namespace craze
