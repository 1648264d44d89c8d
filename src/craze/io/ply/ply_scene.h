// What the header of a PLY file says besides its data.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "craze/io/mesh_source.h"
#include "craze/io/ply/ply_header.h"
#include "craze/io/source_scene.h"
#include "craze/material_look.h"

namespace craze {

struct PlyScene : SourceScene {
  std::filesystem::path folder;                 ///< of the file, for the textures it names
  std::vector<std::string> comments;            ///< behind "comment ", but for materials
  std::vector<std::string> infos;               ///< behind "obj_info "
  std::vector<std::string> textures;            ///< that "comment TextureFile" lines name
  std::map<std::string, std::string> pictures;  ///< bytes of those that are there, by name
  std::vector<MaterialLook> looks;              ///< one per material of the mesh, or none
  int bits = 0;                                 ///< of the colours of vertices

  std::vector<SceneContent> contents() const override;
  int color_bits() const override { return bits; }

  /// The scene with its textures named from the folder of `path`.
  std::shared_ptr<const PlyScene> seen_from(const std::filesystem::path& path) const;
};

/// Which materials a file's textures make where it names none itself: one each, by their numbers
/// ("texnumber"), or the only one for all.
std::vector<std::string> texture_materials(const PlyHeader& header);

/// Brings the textures that the materials of a mesh have. Warns of what cannot be read.
void bring_textures(const std::vector<std::string>& materials, const PlyHeader& header,
                    const MeshSource& source, PlyScene& scene);

}  // namespace craze
