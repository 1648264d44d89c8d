// Colours and attributes that differ where vertices of the input lay at one place.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/morph_animation.h"
#include "craze/surface_mesh.h"
#include "craze/surface_origin.h"

namespace craze {

struct SplitSurface {
  SurfaceMesh mesh;
  std::vector<std::int32_t> sources;  ///< #V: the vertex of the surface that each was
};

/// The surface with the values that its corners have in the input: a vertex where they differ has a
/// copy for each, after all others. `input` has triangles, colours and vertex attributes
/// (engine/welded_values.h). Of `surface` those are replaced that still are as `made` has them;
/// vertices and faces are the same in both, and `origin` is theirs.
SplitSurface with_values_of_input(const SurfaceMesh& surface, const SurfaceMesh& made,
                                  const SurfaceMesh& input, const SurfaceOrigin& origin);

/// The clip, as the split surface moves.
MorphAnimation of_split(const MorphAnimation& animation, const SplitSurface& split);

}  // namespace craze
