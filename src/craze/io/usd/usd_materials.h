// The materials of a USDA file.
#pragma once

#include <map>
#include <string>

#include "craze/io/usd/usd_text.h"
#include "craze/surface_mesh.h"
#include "craze/write_mesh.h"

namespace craze {

/// Materials as they are first asked for, all in the scope "Materials" of the root.
class UsdMaterials {
 public:
  /// Both must outlive this.
  UsdMaterials(const SurfaceMesh& mesh, const MeshFileOptions& options)
      : mesh_(mesh), options_(options) {}

  /// The path of a face material's prim; −1: a plain one.
  const std::string& path(std::int32_t face_material);
  /// The scope with all that were asked for; empty where none was.
  std::string text() const;

 private:
  std::string surface(const std::string& name, const std::string& path,
                      std::int32_t face_material) const;

  const SurfaceMesh& mesh_;
  const MeshFileOptions& options_;
  UsdNames names_;
  std::map<std::int32_t, std::string> paths_;
  std::string text_;
};

}  // namespace craze
