// A mesh to a file of any format the project writes.
#pragma once

#include <filesystem>
#include <string>

#include "craze/io/gltf/morph_animation.h"
#include "craze/mesh/surface_mesh.h"

namespace craze {

/// What not every format can hold.
struct MeshFileOptions {
  std::string objects;  ///< face attribute, one object per value: OBJ and GLB; empty: one object
  const MorphAnimation* animation = nullptr;  ///< GLB
};

/// Writes .ply, .obj, .stl or .glb by extension, whole or not at all. PLY keeps everything but the
/// seams' connectivity; OBJ keeps no attributes; STL only triangles; GLB is in single precision and
/// keeps no face attributes. Throws Error(usage) for another extension or options that the format
/// has no place for, Error(request) for a mesh the format cannot hold, Error(output) where the file
/// cannot be written.
void write_mesh(const std::filesystem::path& path, const SurfaceMesh& mesh,
                const MeshFileOptions& options = {});

/// Throws Error(usage) where the format of `path` cannot hold what the options ask for.
void check_mesh_file(const std::filesystem::path& path, bool objects, bool animation);

/// The extension in lower case with its dot: ".PLY" and ".ply" are the same format.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace craze
