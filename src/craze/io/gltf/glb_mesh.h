// One mesh of a GLB file: its attributes, primitives and morph targets.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/io/gltf/glb_buffer.h"
#include "craze/io/gltf/materials/material_library.h"
#include "craze/io/polygons/unify_corners.h"
#include "craze/mesh/morph_animation.h"
#include "craze/surface_mesh.h"

namespace craze {

/// "_CRACK_DISTANCE" for "crack distance".
std::string glb_attribute_name(const std::string& name);

/// Columns of an attribute that are one accessor, of which none has more than four.
struct GlbColumns {
  std::string name;  ///< glTF's
  int first = 0, components = 1;
};

/// The accessors of an attribute: one, or where it has more than four columns one for each,
/// numbered NAME_0, NAME_1 …
std::vector<GlbColumns> glb_columns(const Attribute& attribute);

/// The materials of a file, numbered as they are first asked for.
class GlbMaterials {
 public:
  /// `library`: those that are known of the mesh's materials, or empty. Must outlive this.
  explicit GlbMaterials(const MaterialLibrary& library) : library_(library) {}

  /// The number of a face material of `mesh`; −1: the plain one.
  std::size_t number(const SurfaceMesh& mesh, std::int32_t face_material);
  /// A dark one for lines, that no light changes.
  std::size_t add_line();
  const nlohmann::ordered_json& json() const { return json_; }

 private:
  const MaterialLibrary& library_;
  std::vector<std::pair<std::int32_t, std::size_t>> known_;
  nlohmann::ordered_json json_ = nlohmann::ordered_json::array();
};

/// The glTF object of lines along these halfedges 3f+i of a mesh, a hair above it, less `origin`.
nlohmann::ordered_json glb_lines(const SurfaceMesh& mesh, const Vec3& origin,
                                 const std::vector<std::int32_t>& halfedges, GlbBuffer& buffer,
                                 GlbMaterials& materials);

/// The glTF object of a mesh, whose vertices are those of `unified`, its numbers appended to the
/// buffer. Positions are written less `origin`. `stages` are morph targets that take back what the
/// stages do. Throws Cancelled.
nlohmann::ordered_json glb_mesh(const SurfaceMesh& mesh, UnifiedCorners unified, const Vec3& origin,
                                const std::vector<MorphStage>& stages, GlbBuffer& buffer,
                                GlbMaterials& materials, const Context& context);

}  // namespace craze
