// The cracks and their grooves at points of the faces' planes.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/products/maps/groove_sizes.h"
#include "craze/products/maps/map_faces.h"
#include "craze/products/maps/map_surface.h"

namespace craze {

/// The crack next to a point.
struct NearestCrack {
  double distance;
  std::int32_t crack = -1;  ///< −1: none; distance is ∞ then
  double along;             ///< where on it the nearest point is: 0 at a, 1 at b
  Vec2 direction;           ///< from a to b in the plane, not unit
  Vec2 foot;                ///< the nearest point itself
};

/// Means over a texel.
struct GrooveMean {
  double mask = 0, height = 0, light = 1;
};

/// Beyond this many texels outside an island the surface is not followed any further.
inline constexpr double texels_followed = 2;

class GrooveSampler {
 public:
  /// For texels of maps of that size: means around points of a face, and where at_border (#F) is
  /// set around those up to texels_followed + 1 outside. References must outlive this. Throws
  /// Cancelled.
  GrooveSampler(const MapSurface& maps, const MapFaces& faces,
                const std::vector<std::uint8_t>& at_border, const GrooveSizes& sizes, int size,
                const Context& context);

  /// The crack next to p, the first of them where several are.
  NearestCrack nearest(std::int32_t face, const Vec2& p) const;
  /// Over the texel around p whose sides are the columns of `texel`, length. Exact for a straight
  /// groove; at corners, tips and junctions 2 × 2 parts of the texel are. `lift`: of the rims
  /// there; grooves go down from it to where they would be without, or from a lift below 0 as deep.
  /// `fragment`: which one p is of, since chips are of one.
  GrooveMean mean(std::int32_t face, const Vec2& p, const Mat2& texel, double lift,
                  std::int32_t fragment) const;
  /// How wide the crack next to p is there, the chips of its rims included.
  double width(std::int32_t face, const NearestCrack& nearest) const;
  /// No point of the surface is farther from a crack; ∞ where a part of it has none.
  double farthest() const { return farthest_; }

 private:
  struct Line {
    Vec2 a, along;
    double inverse_squared_length, half_width_a, half_width_b;
    std::int32_t crack;
  };
  struct Foot {
    double along, distance, half_width;
    Vec2 away;  ///< from there to the point
  };
  /// Lines of one face that follow each other, which most often are those of one crack.
  struct Block {
    Vec2 low, high;  ///< the box around them
    double widest;   ///< of their half widths
    double chipped;  ///< how far chips go from them
    std::int32_t first, last;

    double squared_distance(const Vec2& p) const;
  };
  /// A chip in the plane of a face.
  struct LaidChip {
    const Chip* chip;
    const Line* line;
    Vec2 middle, x, y;      ///< of its frame, on the crack's line
    double half_width;      ///< from there to the rim
    std::int32_t fragment;  ///< it is of; −1: not known

    Vec2 flat(const Vec2& p) const;
  };
  /// Calls visit(LaidChip) for the chips of a face that may reach within `margin` of p.
  template <class Visit>
  void for_each_chip(std::int32_t face, const Vec2& p, double margin, Visit&& visit) const;
  void find_fragments(const MapSurface& maps);
  void make_blocks(std::size_t faces);
  static Foot foot(const Line& line, const Vec2& p);
  static double squared_distance(const Line& line, const Vec2& p);

  const GrooveSizes& sizes_;
  std::vector<std::int32_t> first_;        // #F + 1, offsets into lines_
  std::vector<std::int32_t> first_block_;  // #F + 1, offsets into blocks_
  std::vector<Block> blocks_;
  std::vector<Line> lines_;
  std::vector<std::array<std::int32_t, 2>> fragments_;  // per crack: left and right; −1: not known
  double farthest_ = 0;
};

}  // namespace craze
