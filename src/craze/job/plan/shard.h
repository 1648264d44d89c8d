// A part of a large run, for one of several machines.
#pragma once

#include <cstdint>
#include <string>

namespace craze {

/// Shard `index` of `count`: of numbered pieces of work those that leave `index` over `count`.
struct Shard {
  std::uint64_t index = 0, count = 1;  ///< index < count

  bool has(std::uint64_t piece) const { return piece % count == index; }
};

/// "i/N", i counted from 0 or from 1: N/N is 0/N, so that either way all shards are everything.
/// Throws Error(usage).
Shard parse_shard(const std::string& text);

}  // namespace craze
