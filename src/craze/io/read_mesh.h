// A mesh from a file of any format the project reads.
#pragma once

#include <filesystem>

#include "craze/mesh/surface_mesh.h"

namespace craze {

/// Reads .obj, .ply, .stl, .off, .gltf or .glb, by the file's first bytes where they are telling
/// and by its extension otherwise. The mesh has triangles, finite coordinates and indices in
/// range; nothing else is promised (see mesh/validate). Throws Error(input).
SurfaceMesh read_mesh(const std::filesystem::path& path);

}  // namespace craze
