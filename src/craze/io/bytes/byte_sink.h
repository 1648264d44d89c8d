// The bytes of a file, passed on as they are made.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace craze {

/// Writers append to pending() and call pass_on() from time to time, so that no more than a part of
/// a large file is in memory. Whoever made the sink flushes it.
class ByteSink {
 public:
  /// `take` gets all bytes in their order.
  explicit ByteSink(std::function<void(std::string_view)> take) : take_(std::move(take)) {}

  std::string& pending() { return pending_; }
  void pass_on() {
    if (pending_.size() >= enough) flush();
  }
  void flush() {
    if (!pending_.empty()) take_(pending_);
    pending_.clear();
  }
  /// All of `bytes`, which are not copied.
  void put(std::string_view bytes) {
    flush();
    take_(bytes);
  }

 private:
  static constexpr std::size_t enough = std::size_t{1} << 18;

  std::function<void(std::string_view)> take_;
  std::string pending_;
};

}  // namespace craze
