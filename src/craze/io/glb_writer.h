// glTF 2.0 in one binary file.
#pragma once

#include <string>

#include "craze/mesh/surface_mesh.h"

namespace craze {

/// The mesh as GLB: single precision, axes as they are, one primitive per material (a plain matt
/// one where the mesh names none), vertices copied at seams. UVs are flipped, since glTF counts v
/// downwards. Vertex attributes become `_NAME`, one float accessor each up to four components and
/// one per component above. Throws Error(request) for coordinates beyond single precision and for
/// more than 4 GB.
std::string format_glb(const SurfaceMesh& mesh);

}  // namespace craze
