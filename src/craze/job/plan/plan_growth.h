// What a larger plan does to what a smaller one has made.
#pragma once

#include <cstdint>
#include <optional>

namespace craze {

/// A run that goes on where another ended: in samples and shards, or in rows and parts.
struct PlanGrowth {
  std::uint64_t before = 0, after = 0;  ///< samples or rows
  /// The shard or part that the smaller one ended with, where that holds fewer than it will.
  std::optional<std::uint64_t> piece;
  std::uint64_t held = 0, wanted = 0;  ///< its samples or rows
};

}  // namespace craze
