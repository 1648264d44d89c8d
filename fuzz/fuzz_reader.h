// What every reader owes to any bytes: a mesh that keeps its promises, or an Error(input).
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "craze/error.h"
#include "craze/io/mesh_source.h"
#include "craze/surface_mesh.h"

namespace craze {

inline void require(bool promise) {
  if (!promise) std::abort();
}

inline void check_promises(const SurfaceMesh& mesh) {
  const std::size_t vertices = mesh.positions.size(), faces = mesh.triangles.size();
  require(faces > 0 && mesh.source_faces.size() == faces);
  for (const Vec3& p : mesh.positions) require(p.allFinite());
  for (const Triangle& t : mesh.triangles) {
    for (const std::int32_t v : t) require(v >= 0 && static_cast<std::size_t>(v) < vertices);
  }
  require(mesh.corner_uvs.empty() || mesh.corner_uvs.size() == 3 * faces);
  for (const Vec2& uv : mesh.corner_uvs) require(uv.allFinite());
  require(mesh.corner_normals.empty() || mesh.corner_normals.size() == 3 * faces);
  for (const Vec3& n : mesh.corner_normals) require(std::abs(n.norm() - 1) < 1e-6);
  require(mesh.vertex_colors.empty() || mesh.vertex_colors.size() == vertices);
  for (const Color& color : mesh.vertex_colors) {
    for (const float c : color) require(c >= 0 && c <= 1);
  }
  require(mesh.face_materials.empty() || mesh.face_materials.size() == faces);
  for (const std::int32_t m : mesh.face_materials) {
    require(m >= -1 && m < static_cast<std::int32_t>(mesh.material_names.size()));
  }
  for (const Attribute& a : mesh.vertex_attributes) {
    require(a.values.size() == static_cast<std::size_t>(a.components) * vertices);
    for (const double x : a.values) require(std::isfinite(x));
  }
  for (const Attribute& a : mesh.face_attributes) {
    require(a.values.size() == static_cast<std::size_t>(a.components) * faces);
    for (const double x : a.values) require(std::isfinite(x));
  }
}

/// Reads the bytes; any exception but Error(input) is a find, and so is a message or warning of two
/// lines. No other file is opened.
inline int fuzz_reader(const std::uint8_t* data, std::size_t size,
                       SurfaceMesh (*reader)(const MeshSource&)) {
  const std::string name = "fuzz";
  const FileLoader no_files;
  const Context context;
  std::vector<std::string> warnings, textures;
  std::shared_ptr<const SourceScene> scene;
  try {
    check_promises(reader({std::string_view(reinterpret_cast<const char*>(data), size), name,
                           no_files, context, warnings, textures, scene}));
  } catch (const Error& e) {
    require(e.kind() == ErrorKind::input);
    require(std::string_view(e.what()).find('\n') == std::string_view::npos);
  }
  for (const std::string& w : warnings) require(w.find('\n') == std::string::npos);
  return 0;
}

}  // namespace craze
