// A set of numbers without a node for each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "craze/base/random.h"

namespace craze {

/// Of any 64-bit numbers but 2⁶⁴ − 1; open addressing, at most half full.
class NumberSet {
 public:
  bool contains(std::uint64_t x) const {
    return !places_.empty() && places_[place_of(x, places_)] == x;
  }

  /// Whether it was not yet there.
  bool insert(std::uint64_t x) {
    if (2 * (size_ + 1) > places_.size()) grow();
    std::uint64_t& place = places_[place_of(x, places_)];
    if (place == x) return false;
    place = x;
    ++size_;
    return true;
  }

  /// Its room is kept.
  void clear() {
    std::fill(places_.begin(), places_.end(), none);
    size_ = 0;
  }

 private:
  static constexpr std::uint64_t none = ~std::uint64_t{0};
  static constexpr std::size_t least = 64;

  /// Where x is, or would be.
  static std::size_t place_of(std::uint64_t x, const std::vector<std::uint64_t>& places) {
    const std::size_t mask = places.size() - 1;
    std::size_t i = static_cast<std::size_t>(hash_bits(x)) & mask;
    while (places[i] != none && places[i] != x) i = (i + 1) & mask;
    return i;
  }

  void grow() {
    std::vector<std::uint64_t> larger(places_.empty() ? least : 2 * places_.size(), none);
    for (const std::uint64_t x : places_) {
      if (x != none) larger[place_of(x, larger)] = x;
    }
    places_ = std::move(larger);
  }

  std::vector<std::uint64_t> places_;  // a power of two of them
  std::size_t size_ = 0;
};

}  // namespace craze
