// post.chipping: bites out of the rims of cracks, finer than any mesh.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "craze/products/maps/map_surface.h"
#include "craze/recipe.h"
#include "craze/tensor.h"

namespace craze {

/// A bite like half a shell, deepest at the rim. In its own frame x runs along the crack from a to
/// b and y from the rim into the piece, from the middle of the chip, lengths.
struct Chip {
  std::int32_t crack;            ///< index of the piece of crack that its middle lies on
  bool left;                     ///< side of that, from a to b and seen from outside
  double along;                  ///< of its middle, from a, length
  double reach;                  ///< half its length along the rim
  double inwards;                ///< no point of it is deeper inside the piece
  double depth;                  ///< below the surface, at its middle
  std::array<double, 3> ragged;  ///< how its outline waves inside the ellipse of the two above

  /// 0 in the middle, 1 on the outline, and on as far outside.
  double outline(const Vec2& p) const;
  /// How deep the surface lies there; 0 outside.
  double depth_at(const Vec2& p) const;
  /// How far the chip goes into the piece at x; 0 beside it.
  double inwards_at(double x) const;
};

struct ChipOptions {
  double share = 0;    ///< of the rims, > 0 … 1
  double size = 0;     ///< the largest reach; 0: automatic
  double spacing = 0;  ///< mean distance between cracks, length
  double deepest = std::numeric_limits<double>::infinity();  ///< length
  std::uint64_t seed = 1;
};

/// How much of the depth of a wall chips may take.
inline constexpr double chips_of_wall = 0.8;

/// How deep chips may go: most of a wall, half of a solid piece.
ChipOptions chip_options(const PostParameters& post, double spacing, std::uint64_t seed);

struct Chips {
  std::vector<Chip> chips;          ///< by crack, then by side
  std::vector<std::int32_t> first;  ///< #cracks + 1, offsets into chips; empty: no chips
  std::vector<double> extent;       ///< #cracks: no chip goes farther from the piece of crack
  std::vector<std::string> warnings;
};

/// Chips at random, so that they cover the share of both rims of all cracks, twice as many per
/// length at junctions as elsewhere and on the last cracks a third as many as on the first. Where a
/// crack narrows to its tip chips are as small. half_width: per crack at a and b.
Chips place_chips(const std::vector<MapCrack>& cracks,
                  const std::vector<std::array<double, 2>>& half_width, const ChipOptions& options);

/// Where the sides of a crack's pieces lie in a mesh that is cut open along them.
struct CrackSide {
  std::int32_t halfedge = -1;  ///< −1: not known, since it was split
};
/// Per crack: left, right.
std::vector<std::array<CrackSide, 2>> sides_of_cracks(const std::vector<MapCrack>& cracks,
                                                      const TriangleMesh& cut);

}  // namespace craze
