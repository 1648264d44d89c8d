// How far curled pieces lift the surface of maps.
#pragma once

#include <array>
#include <vector>

#include "craze/products/maps/groove_sizes.h"
#include "craze/products/maps/map_faces.h"
#include "craze/products/maps/map_surface.h"

namespace craze {

/// post.curl: at a crack half its width times the curl, from there fading into the pieces as in an
/// opened mesh (opening/curl.h). Smooth within each piece and across the edges between them, apart
/// on the two sides of a crack; the same on both sides of a seam of the UVs.
class MapLift {
 public:
  /// None where the curl is 0 or the surface is not known cut.
  MapLift(const MapSurface& maps, const MapFaces& faces, const GrooveSizes& sizes);

  /// At the point p of the plane of the piece's face, inside it or some texels outside.
  double at(std::int32_t piece, const Vec2& p) const;
  /// What no lift inside a piece is below or above; both 0 where there is none.
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

 private:
  /// A cubic Bézier triangle through the lifts at its corners with the slopes there.
  struct Patch {
    std::array<Vec2, 3> corners;
    std::array<Vec2, 3> slopes;
    std::array<double, 3> at_corner;
    std::array<std::array<double, 2>, 3>
        on_side;  ///< of the side from corner i: near i, near i + 1
    double inside;

    double at(const Vec3& w) const;
  };

  std::vector<Patch> patches_;  // per piece; empty: no lift
  double lowest_ = 0, highest_ = 0;
};

}  // namespace craze
