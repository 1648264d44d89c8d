#include "craze/base/parallel.h"

#include <algorithm>

#ifndef __EMSCRIPTEN__
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "craze/base/thread_sanitizer.h"
#endif

namespace craze {

int thread_count(int threads) {
#ifndef __EMSCRIPTEN__
  if (threads == 0) return std::max(1, tbb::this_task_arena::max_concurrency());
#endif
  return std::max(1, threads);
}

void parallel_for(int threads, std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t chunks = (n + grain - 1) / grain;
  const auto run_chunk = [&](std::size_t c) { body(c * grain, std::min(n, (c + 1) * grain)); };
#ifndef __EMSCRIPTEN__
  if (threads != 1 && chunks > 1) {
    KnownOrder start, end;
    const auto run_ordered = [&](std::size_t c) {
      start.seen();
      run_chunk(c);
      end.passed();
    };
    const auto loop = [&] { tbb::parallel_for(std::size_t{0}, chunks, run_ordered); };
    start.passed();
    // An arena of its own costs more than most loops: only where fewer threads are asked for.
    if (threads == 0 || threads >= tbb::this_task_arena::max_concurrency()) {
      loop();
    } else {
      tbb::task_arena(threads).execute(loop);
    }
    end.seen();
    return;
  }
#endif
  for (std::size_t c = 0; c < chunks; ++c) run_chunk(c);
}

}  // namespace craze
