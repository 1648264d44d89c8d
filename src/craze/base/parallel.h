// Loops over index ranges on several threads.
#pragma once

#include <cstddef>
#include <functional>
#include <typeinfo>

#include "craze/threads.h"

namespace craze {

/// Runs body(begin, end) over [0, n) in chunks of exactly `grain` > 0 (the last one shorter). The
/// chunks do not depend on the number of threads, so a body that writes only to its own indices,
/// or to one slot per chunk, gives the same result on any number. One thread, or a single chunk:
/// runs in the calling thread. Where bodies throw, the exception of the first such chunk comes
/// out, as it would from one thread; which later chunks have run is then open. A body may call
/// parallel_for itself. Where loops are timed (work_and_span.h) this one goes by
/// `name`, or the type of its body.
void parallel_for(const Threads& threads, std::size_t n, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body,
                  const std::type_info* name = nullptr);

}  // namespace craze
