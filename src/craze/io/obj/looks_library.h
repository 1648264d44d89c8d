// A material library for a mesh whose materials come from a file of another kind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "craze/io/files/look_pictures.h"
#include "craze/material_look.h"
#include "craze/surface_mesh.h"

namespace craze {

/// What is written beside an OBJ file.
struct LooksLibrary {
  std::filesystem::path file;  ///< of the materials; empty: none is needed
  std::string text;
};

/// Base colours (`Kd`, `d`) and their pictures (`map_Kd` with `-s` and `-o`) of a mesh that goes to
/// `path`, as NAME.mtl. looks: one per material of the mesh, walls after them; `pictures` says what
/// the files of theirs are called.
LooksLibrary looks_library(const std::filesystem::path& path, const SurfaceMesh& mesh,
                           const std::vector<MaterialLook>& looks, LookPictures& pictures);

}  // namespace craze
