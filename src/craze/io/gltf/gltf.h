// glTF 2.0, as JSON or as GLB.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "craze/mesh/surface_mesh.h"

namespace craze {

/// Returns the bytes of the file that a buffer's URI names; throws Error(input) where it must not.
using GltfLoader = std::function<std::string(const std::string& uri)>;

/// Reads all triangles of the default scene (of every root node where the file has no scene), its
/// nodes' transforms applied: lists, strips and fans; POSITION, NORMAL, TEXCOORD_0 (v turned to
/// count upwards), COLOR_0 and custom `_NAME` attributes (as "name"); material names. Vertices are
/// as the file has them, so seams stay open. Buffers may be data URIs, GLB's chunk, or files that
/// `loader` brings; without one, files are an error. Compressed and sparse data are refused.
/// Instances may expand a file to at most 4 million elements more than twice its bytes. Throws
/// Error(input).
SurfaceMesh read_gltf(std::string_view bytes, const std::string& name,
                      const GltfLoader& loader = nullptr);

/// A loader of files in one folder or below it. Refuses absolute paths, `..`, URIs with a scheme
/// and links that lead outside.
GltfLoader load_from_folder(const std::filesystem::path& folder);

}  // namespace craze
