// Decides which faces of a triangle soup are neighbours, and which way each is to face.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// Neighbours and orientation of a soup. Halfedge 3f+i runs from corner i to corner i+1 of face f
/// as it stands after the flips: a flipped face has its corners 1 and 2 exchanged.
struct EdgePairs {
  std::vector<std::int32_t>
      opposite;               ///< 3 #F, −1: open. Opposite sides run in opposite directions
  std::vector<char> flipped;  ///< #F
  std::int32_t flips = 0;
  std::int32_t crowded_edges = 0;  ///< with more than two faces
  std::int32_t cut_edges = 0;      ///< opened although faces lay on both sides
};

/// Joins faces across edges. Two faces at an edge are neighbours. Of more, the two sides of a wall
/// go first, each to the face that bounds the same solid; then those that continue each other best
/// are joined two by two: equally directed pairs before others, then the flattest; at an edge with
/// more than sixteen faces none is. Orientation floods from face to face; where it comes back
/// reversed (a Möbius strip) the edge is opened. A part without open edges is turned outward,
/// unless it is consistent as it came and lies within the box of a larger one, as the inner wall
/// of a hollow solid does; any other part is turned the way most of its faces were.
/// Faces have three different corners; two with the same three are the two sides of a wall.
/// O(#F log #F).
EdgePairs pair_edges(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);

}  // namespace craze
