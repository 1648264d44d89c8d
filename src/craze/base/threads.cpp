#include "craze/threads.h"

#include <algorithm>
#include <thread>

#include "craze/base/executor.h"

namespace craze {

namespace {

int thread_count(int asked) {
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
  static_cast<void>(asked);
  return 1;
#else
  // hardware_concurrency() is 0 where it is not known.
  if (asked == 0) asked = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(asked, 1, Threads::max_count);
#endif
}

}  // namespace

Threads::Threads(int count)
    : count_(thread_count(count)), executor_(count_ > 1 ? make_executor(count_) : nullptr) {}

}  // namespace craze
