// Loops over index ranges on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace craze {

/// The number of threads that `threads` stands for: itself, or one per core where it is 0.
int thread_count(int threads);

/// Runs body(begin, end) over [0, n) in chunks of exactly `grain` (the last one shorter). The
/// chunks do not depend on the number of threads, so a body that writes only to its own indices,
/// or to one slot per chunk, gives the same result on any number. threads = 0: one per core;
/// threads = 1, or a single chunk: runs in the calling thread.
void parallel_for(int threads, std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace craze
