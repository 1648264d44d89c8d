// The nearest point of the input near a known face, by walking from face to face.
#pragma once

#include <cstdint>

#include "craze/mesh/closest_point.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// Goes downhill in distance over a surface: from a face to one beside it that is nearer, until
/// none is. What it finds is nearest among its surroundings; a tree of boxes finds what is nearest
/// of all, for several times the work.
class SurfaceWalk {
 public:
  /// Keeps references. tree: of the faces of `surface`, in their numbers.
  SurfaceWalk(const TriangleMesh& surface, const ClosestPoint& tree)
      : surface_(surface), tree_(tree) {}

  /// From filter.hint; a walk that leads farther than `trusted` asks the tree. Thread-safe.
  ClosestPoint::Hit find(const Vec3& point, const ClosestPoint::Filter& filter,
                         double trusted) const;

 private:
  ClosestPoint::Hit walk(const Vec3& point, const ClosestPoint::Filter& filter) const;

  const TriangleMesh& surface_;
  const ClosestPoint& tree_;
};

}  // namespace craze
