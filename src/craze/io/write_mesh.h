// A mesh to a file of any format the project writes.
#pragma once

#include <filesystem>

#include "craze/mesh/surface_mesh.h"

namespace craze {

/// Writes .ply, .obj, .stl or .glb by extension, whole or not at all. PLY keeps everything but the
/// seams' connectivity; OBJ keeps no attributes; STL only triangles; GLB is in single precision and
/// keeps no face attributes. Throws Error(usage) for another extension, Error(request) for a mesh
/// the format cannot hold, Error(output) where the file cannot be written.
void write_mesh(const std::filesystem::path& path, const SurfaceMesh& mesh);

/// The extension in lower case with its dot: ".PLY" and ".ply" are the same format.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace craze
