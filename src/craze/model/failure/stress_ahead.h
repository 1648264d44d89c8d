// What a crack tip turns by: the stress ahead of it.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/number_set.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/stress_field.h"
#include "craze/tensor.h"

namespace craze {

/// ς at a tip tells how hard the crack is pulled, but which way only to the precision of one star
/// of triangles, in the tip's own steep field. The mean over what is about to crack tells that
/// better, and feels a free edge ahead early enough to meet it squarely: the nonlocal direction of
/// Wells & Sluys, "A new method for modelling cohesive cracks using finite elements" (2001).
class StressAhead {
 public:
  /// The mean of σ over the faces within `length` of the crack tip v and ahead of it, by area and
  /// (1 − d²/length²)², with d the distance of the centroid; force/length, in the tangent plane of
  /// v. Faces are reached over uncut edges, turned into that plane, and left out where the surface
  /// has bent away by 60° or more. Zero where none is left.
  Sym3 mean(const TriangleMesh& mesh, const StressField& field, std::int32_t v, double length);

 private:
  std::vector<std::int32_t> faces_;
  NumberSet reached_;  // of those
};

}  // namespace craze
