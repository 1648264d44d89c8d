// Whole cracks: the edges of a network joined where they run on, with who ends on whom.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "craze/model/crack_network.h"

namespace craze {

/// A crack from end to end.
struct WholeCrack {
  std::vector<std::int32_t>
      nodes;  ///< of the network, in order; a closed crack ends where it begins
  std::vector<std::int32_t> edges;  ///< one fewer
  double time = 0;                  ///< load when its first edge opened
  std::int32_t event = 0;           ///< the event that opened it
  std::int32_t order = 0;           ///< its place in the order of opening, from 1
  std::int32_t parent =
      -1;  ///< index of the crack that it ends on and that was there before; −1: none
};

/// In the order of opening. At a node where two cracks meet the two edges are one crack; where
/// three or more, those that run straightest on, two by two, as long as they turn less than 45°;
/// not on the border.
std::vector<WholeCrack> whole_cracks(const CrackNetwork& network);

/// "end", "border", "t", "y", "x" (four or more), "other" (of three, neither T nor Y within 20°),
/// by the directions over about the length of three edges; "" for the inside of a crack.
std::vector<std::string_view> junction_kinds(const CrackNetwork& network);

}  // namespace craze
