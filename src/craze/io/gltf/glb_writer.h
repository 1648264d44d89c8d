// glTF 2.0 in one binary file.
#pragma once

#include <string>

#include "craze/io/gltf/morph_animation.h"
#include "craze/mesh/surface_mesh.h"

namespace craze {

struct GlbOptions {
  /// Written as morph targets, whose weights an animation brings from 1 to 0: readers that know
  /// neither see the mesh as it is. Null: nothing moves.
  const MorphAnimation* animation = nullptr;
  /// A face attribute: each of its values becomes a node NAME_VALUE with its origin at its
  /// centroid, so that it turns and falls about its own middle. Empty: one node.
  std::string objects;
};

/// The mesh as GLB: single precision, axes as they are, one primitive per material (a plain matt
/// one where the mesh names none, dark for "crack_wall"), vertices copied at seams. UVs are
/// flipped, since glTF counts v downwards. Vertex attributes become `_NAME`, one float accessor
/// each up to four components and one per component above. Parts of a mesh that met still meet, to
/// the last bit. Throws Error(request) for coordinates beyond single precision and for more than 4
/// GB.
std::string format_glb(const SurfaceMesh& mesh, const GlbOptions& options = {});

}  // namespace craze
