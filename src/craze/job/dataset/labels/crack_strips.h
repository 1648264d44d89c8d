// Which crack a point of a scene's surface lies in, or near.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "craze/job/dataset/scene/scene.h"

namespace craze {

/// How a mask differs from what is there: label noise.
struct LabelNoise {
  double grow = 0;                    ///< pixels on each side
  std::vector<std::uint8_t> dropped;  ///< per crack: not in the mask; empty: all are
};

/// The crack whose edge is nearest to a point.
struct NearestStrip {
  double outside = std::numeric_limits<double>::max();  ///< from its edge, length; below 0: inside
  std::int32_t line = -1;  ///< of the scene's lines; −1: none is near
  double along = 0;        ///< 0 … 1 on the line
};

/// A scene's cracks as strips of its surface (scene.h). Points and lengths are the model's.
class CrackStrips {
 public:
  CrackStrips(const Scene& scene, const LabelNoise& noise) : scene_(scene), noise_(noise) {}

  Vec3 point_of(const render::Hit& hit) const;
  /// Unit, of the face as it is wound.
  Vec3 normal_of(std::int32_t face) const;
  /// Of a point of that face; `kept_only` leaves out cracks that are dropped.
  NearestStrip nearest(std::int32_t face, const Vec3& point, bool kept_only) const;
  /// From a point of that face to the nearest centre line, along the surface; at most `limit`.
  double distance(std::int32_t face, const Vec3& point, double limit) const;
  /// Of the crack, at the place nearest to a point.
  double width(const NearestStrip& at) const { return 2 * half_width(at.line, at.along); }
  /// That width as the picture shows it, pixels; `normal` is the surface's there.
  double seen_width(const NearestStrip& at, const Vec3& normal) const;
  /// Of the scene's cracks; −1: none.
  std::int32_t crack(const NearestStrip& at) const {
    return at.line < 0 ? -1 : scene_.crack_of_line[at.line];
  }

 private:
  double half_width(std::int32_t line, double t) const;

  const Scene& scene_;
  const LabelNoise& noise_;
};

}  // namespace craze
