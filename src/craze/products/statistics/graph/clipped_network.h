// Builds a planar network from line pieces, cut off at a square window.
#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "craze/model/crack_network.h"

namespace craze {

/// Pieces meet at end points of equal key.
class ClippedNetwork {
 public:
  using Key = std::array<std::int32_t, 3>;

  /// The window is [0, side]².
  explicit ClippedNetwork(double side) : side_(side) {}

  void add(const Key& key_a, const Vec2& a, const Key& key_b, const Vec2& b);

  /// With the kinds of the nodes set.
  CrackNetwork take();

 private:
  std::int32_t node(const Key& key, const Vec2& p);
  std::int32_t border_node(const Vec2& p);

  double side_;
  CrackNetwork network_;
  std::map<Key, std::int32_t> node_of_;
};

/// Sets each node's kind from its number of edges; border nodes stay.
void set_kinds(CrackNetwork& network);

}  // namespace craze
