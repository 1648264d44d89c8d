// Which cracks matter to each face, in the face's own plane.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "craze/context.h"
#include "craze/products/maps/map_surface.h"

namespace craze {

/// A face laid into the plane: corner 0 at the origin, corner 1 on the x axis.
struct FacePlane {
  Vec3 origin, x, y;
  std::array<Vec2, 3> corners;

  Vec2 flat(const Vec3& p) const { return {(p - origin).dot(x), (p - origin).dot(y)}; }
};

FacePlane face_plane(const SurfaceMesh& surface, std::int32_t f);

/// A crack as seen from a face: unfolded over the edges between them into its plane, so that a
/// straight distance there is one along the surface.
struct SeenCrack {
  Vec2 a, b;
  std::int32_t crack;  ///< index into MapSurface::cracks
};

/// How far cracks have to be seen, lengths.
struct SightLimits {
  std::vector<double> margin;  ///< #F: points up to this far outside a face are asked for as well
  std::vector<double>
      reach;  ///< per crack: it matters within this distance though others are nearer
};

struct SeenCracks {
  std::vector<std::int32_t> first;  ///< #F + 1, offsets into cracks
  std::vector<SeenCrack> cracks;
  std::vector<double> farthest;  ///< #F: no point of it is farther from a crack; ∞: none is there

  std::span<const SeenCrack> of(std::int32_t face) const {
    const auto begin = static_cast<std::size_t>(first[face]);
    return {cracks.data() + begin, static_cast<std::size_t>(first[face + 1]) - begin};
  }
};

/// For each face every crack that is the nearest to some point of it or of its margin, or within
/// reach of one. Cracks are carried over the faces, nearest first, across other cracks too but
/// never over a border: one on the far side of a thin wall is as far away as the way round. Throws
/// Cancelled.
SeenCracks seen_cracks(const MapSurface& maps, const SightLimits& limits, const Context& context);

}  // namespace craze
