// Runs of a plan beside each other.
#pragma once

#include <cstddef>
#include <functional>

#include "craze/context.h"

namespace craze {

/// Calls work(i, c) for each i in [0, n), side by side, with one thread each; a single one has all
/// the threads of `context`. c tells of no progress. It is cancelled where `context` is, which is
/// asked in the caller's thread alone, as Context says, by the work there and while it waits for
/// the others, which hear of it from there. Throws what the first work that fails throws.
void side_by_side(std::size_t n, const Context& context,
                  const std::function<void(std::size_t, const Context&)>& work);

}  // namespace craze
