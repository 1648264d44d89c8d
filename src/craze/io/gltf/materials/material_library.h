// Materials of the input, for a GLB that keeps nothing else of it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "craze/io/source_scene.h"
#include "craze/surface_mesh.h"

namespace craze {

/// glTF objects that refer to each other by number.
struct MaterialLibrary {
  nlohmann::ordered_json materials =
      nlohmann::ordered_json::array();  ///< by the mesh's; null: unknown
  nlohmann::ordered_json textures = nlohmann::ordered_json::array();
  nlohmann::ordered_json samplers = nlohmann::ordered_json::array();
  nlohmann::ordered_json images = nlohmann::ordered_json::array();  ///< without their bytes
  std::vector<std::string> image_bytes;                             ///< "" for one that has a URI
};

/// Of a glTF document all that its materials need, but for textures by UV sets that a mesh has not;
/// of an OBJ file's libraries colour, opacity, emission, roughness, metalness and pictures; of a
/// PLY file its textures. Empty for anything else. `mesh` was made of the scene's surface.
MaterialLibrary material_library(const SourceScene* scene, const SurfaceMesh& mesh);

/// The names of extensions that a document's objects use, in order.
std::vector<std::string> extensions_of(const nlohmann::ordered_json& json);

}  // namespace craze
