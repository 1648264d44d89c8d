// A mesh from bytes, or from a file, of any format the project reads.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "craze/context.h"
#include "craze/material_look.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Returns the bytes of another file that a mesh's file names; throws Error(input) where it must
/// not.
using FileLoader = std::function<std::string(const std::string& uri)>;

/// What a file holds besides its surface, kept for write_mesh (write_mesh.h). Immutable.
class SourceScene;

/// What a file held.
struct MeshFile {
  SurfaceMesh mesh;
  std::vector<std::string> warnings;  ///< one sentence for each kind of thing that was left out
  std::vector<std::string> textures;  ///< pictures that the file names, in its own words
  /// One per material of the mesh; one for all faces of a mesh without; none where the file says
  /// nothing.
  std::vector<MaterialLook> looks;
  std::shared_ptr<const SourceScene> scene;  ///< null where there is nothing else
};

/// Reads a file's bytes: .obj, .ply, .stl, .off, .gltf or .glb, by what they are where that can be
/// told and by the extension of `name` otherwise. `name` also stands for the file in messages. Text
/// may be UTF-8 with or without its mark, or UTF-16 with it. `files` brings other files that it
/// names (buffers of .gltf); without it, needing one is an error. The mesh has triangles, finite
/// coordinates and indices in range; nothing else is promised (see mesh/validate). Reports "load".
/// Throws Error(input), and Cancelled.
MeshFile read_mesh(std::string_view bytes, const std::string& name, const FileLoader& files = {},
                   const Context& context = {});

/// The same from a file, and those beside it or below its folder that it names.
MeshFile read_mesh_file(const std::filesystem::path& path, const Context& context = {});

/// A loader of files that are already in memory, by the name that the mesh's file gives them.
FileLoader load_from_memory(std::map<std::string, std::string> files);

}  // namespace craze
