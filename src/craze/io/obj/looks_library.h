// A material library for a mesh whose materials come from a file of another kind.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "craze/material_look.h"
#include "craze/surface_mesh.h"

namespace craze {

/// What is written beside an OBJ file.
struct LooksLibrary {
  std::filesystem::path file;  ///< of the materials; empty: none is needed
  std::string text;
  /// Pictures that only the input holds, by what they are called.
  std::vector<std::pair<std::filesystem::path, std::shared_ptr<const std::string>>> pictures;
};

/// Base colours (`Kd`, `d`) and their textures (`map_Kd` with `-s` and `-o`) of a mesh that goes to
/// `path`, as NAME.mtl; textures inside the input become NAME_N.png or .jpg, others are named where
/// they are. looks: one per material of the mesh, walls after them, files named from the folder of
/// `path`.
LooksLibrary looks_library(const std::filesystem::path& path, const SurfaceMesh& mesh,
                           const std::vector<MaterialLook>& looks);

}  // namespace craze
