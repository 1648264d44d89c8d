// A loop over an index range on several threads that says how far it is and can be cancelled.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string_view>

#include "craze/base/parallel.h"
#include "craze/context.h"

namespace craze {

/// parallel_for over [0, n) in chunks of `grain`, a slice of about a tenth of a second at a time.
/// After each, in the caller's thread, reports `phase` with the fraction done; between two it
/// throws Cancelled where the context says so. How the range is sliced depends on the machine: the
/// body must write to its own indices alone, whatever the chunk.
inline void reporting_loop(const Context& context, std::string_view phase, std::size_t n,
                           std::size_t grain,
                           const std::function<void(std::size_t, std::size_t)>& body) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds short_slice{50}, long_slice{150};
  std::size_t chunks = static_cast<std::size_t>(std::max(1, context.threads.count()));
  const std::size_t fewest = chunks;
  for (std::size_t begin = 0; begin < n;) {
    const std::size_t end = std::min(n, begin + chunks * grain);
    const auto start = Clock::now();
    parallel_for(
        context.threads, end - begin, grain,
        [&](std::size_t b, std::size_t e) { body(begin + b, begin + e); }, &body.target_type());
    const auto took = Clock::now() - start;
    if (took < short_slice) chunks *= 2;
    if (took > long_slice) chunks = std::max(fewest, chunks / 2);
    begin = end;
    if (begin < n) context.check();
    context.report({phase, static_cast<double>(begin) / static_cast<double>(n)});
  }
}

}  // namespace craze
