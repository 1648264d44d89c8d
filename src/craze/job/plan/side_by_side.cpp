#include "craze/job/plan/side_by_side.h"

#include <atomic>
#include <thread>

#include "craze/base/parallel.h"

namespace craze {

void side_by_side(std::size_t n, const Context& context,
                  const std::function<void(std::size_t, const Context&)>& work) {
  if (n == 1) {
    work(0, {context.threads, {}, context.cancelled});
    return;
  }
  std::atomic<bool> stop{false};
  const std::thread::id caller = std::this_thread::get_id();
  const Context single{Threads(1), {}, [&] {
                         if (std::this_thread::get_id() == caller && context.is_cancelled()) {
                           stop = true;
                         }
                         return stop.load();
                       }};
  parallel_for(context.threads, n, 1, [&](std::size_t i, std::size_t) { work(i, single); });
}

}  // namespace craze
