// Loops on oneTBB: an arena for each handle, in it workers that TBB shares out.
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "craze/base/executor.h"

namespace craze {

namespace {

class Arena : public Executor {
 public:
  // TBB complains aloud where more are asked for than it has.
  explicit Arena(int threads)
      : arena_(std::min(threads, tbb::this_task_arena::max_concurrency())) {}

 private:
  void share_out(std::size_t n, const Task& task, const std::type_info&) override {
    arena_.execute([&] { tbb::parallel_for(std::size_t{0}, n, task); });
  }

  tbb::task_arena arena_;  // takes nothing before its first loop
};

}  // namespace

std::shared_ptr<Executor> make_executor(int threads) {
  return std::make_shared<Arena>(threads);
}

}  // namespace craze
