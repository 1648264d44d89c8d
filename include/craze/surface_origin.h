// Where each face of a cut mesh lies in the mesh that was read.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/tensor.h"

namespace craze {

/// Ties a mesh made from an input to that input, so that whoever writes it can keep what the input
/// had. Faces below wall_begin lie in an input triangle each, with its winding but where repair
/// turned it round; together they cover the triangles that they name. Input triangles that no face
/// names were left out of the run.
struct SurfaceOrigin {
  /// #F: the input's triangle, as read and before any repair, that the face is a part of; for a
  /// side wall of a crack the input's triangle beside it.
  std::vector<std::int32_t> face;
  /// 3 #F: barycentric coordinates of corner i of face f in its triangle at 3f+i, sum 1, before
  /// anything was displaced; exactly 1 at the triangle's own corners. For walls those of the rim's
  /// vertex above.
  std::vector<Vec3> weights;
  std::int32_t wall_begin = 0;  ///< faces from here on are side walls; #F: there are none
};

}  // namespace craze
