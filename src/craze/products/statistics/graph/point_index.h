// Points by their exact position.
#pragma once

#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <utility>
#include <vector>

#include "craze/base/random.h"
#include "craze/tensor.h"

namespace craze {

/// Gives equal positions (0 and −0 are equal) the same index, in order of first appearance.
class PointIndex {
 public:
  std::int32_t add(const Vec3& p) {
    const auto [entry, inserted] = index_.try_emplace(key(p), static_cast<int>(points_.size()));
    if (inserted) points_.push_back(p);
    return entry->second;
  }
  /// −1 if no such point was added.
  std::int32_t find(const Vec3& p) const {
    const auto entry = index_.find(key(p));
    return entry == index_.end() ? -1 : entry->second;
  }
  std::vector<Vec3> take() { return std::move(points_); }

 private:
  using Key = std::array<std::uint64_t, 3>;
  struct Hash {
    std::size_t operator()(const Key& k) const {
      return hash_bits(k[0] ^ hash_bits(k[1] ^ hash_bits(k[2])));
    }
  };
  static Key key(const Vec3& p) {
    Key k;
    for (int i = 0; i < 3; ++i) {
      const double x = p[i] + 0.0;  // −0 becomes 0
      std::memcpy(&k[i], &x, sizeof x);
    }
    return k;
  }

  std::unordered_map<Key, std::int32_t, Hash> index_;
  std::vector<Vec3> points_;
};

}  // namespace craze
