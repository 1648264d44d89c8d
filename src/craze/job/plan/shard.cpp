#include "craze/job/plan/shard.h"

#include <charconv>

#include "craze/error.h"

namespace craze {

Shard parse_shard(const std::string& text) {
  const char* const end = text.data() + text.size();
  Shard shard;
  const auto first = std::from_chars(text.data(), end, shard.index);
  bool good = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  if (good) {
    const auto second = std::from_chars(first.ptr + 1, end, shard.count);
    good = second.ec == std::errc() && second.ptr == end && shard.count > 0 &&
           shard.index <= shard.count;
  }
  if (!good) {
    throw Error(ErrorKind::usage, "not a shard", "--shard " + text,
                "write i/N, N at least 1 and i counted from 0 or from 1");
  }
  shard.index %= shard.count;
  return shard;
}

}  // namespace craze
