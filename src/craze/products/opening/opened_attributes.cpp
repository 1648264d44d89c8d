#include "craze/products/opening/opened_attributes.h"

#include <algorithm>

namespace craze {

namespace {

/// Per face the halfedge of the cut mesh that lends a corner its UV: its own, that of the corner
/// above it, or for a wall one at the surface vertex the corner belongs to.
std::int32_t corner_source(const TriangleMesh& cut, const OpenedMesh& opened, std::size_t face,
                           int corner, std::int32_t above) {
  const std::int32_t f = opened.face_of[face];
  if (f >= 0) return 3 * f + corner;
  if (above >= 0) return above;
  return cut.first_halfedge(opened.vertex_of[opened.mesh.triangles[face][corner]]);
}

Vec3 face_normal(const SurfaceMesh& mesh, std::size_t f) {
  const Triangle& t = mesh.triangles[f];
  const Vec3& p = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p).normalized();
}

/// Cores come after the fragments.
void number_cores(const OpenedMesh& opened, Attribute& fragment) {
  if (!opened.solid || opened.solid->core.empty()) return;
  const auto begin = static_cast<std::size_t>(opened.solid->core_begin);
  double last = -1;
  for (std::size_t f = 0; f < begin; ++f) last = std::max(last, fragment.values[f]);
  for (std::size_t f = begin; f < fragment.values.size(); ++f) {
    fragment.values[f] = last + 1 + opened.solid->core[f - begin];
  }
}

void add_materials(SurfaceMesh& result, const SurfaceMesh& cut_surface, const OpenedMesh& opened) {
  result.material_names = cut_surface.material_names;
  const auto wall = static_cast<std::int32_t>(result.material_names.size());
  result.material_names.emplace_back("crack_wall");
  result.face_materials.assign(opened.beside.size(), -1);
  for (std::size_t f = 0; f < opened.beside.size(); ++f) {
    if (opened.face_of[f] < 0) {
      result.face_materials[f] = wall;
    } else if (!cut_surface.face_materials.empty()) {
      result.face_materials[f] = cut_surface.face_materials[opened.beside[f]];
    }
  }
}

}  // namespace

std::int32_t corner_above(const TriangleMesh& cut, const OpenedMesh& opened, std::size_t face,
                          int corner) {
  if (!opened.solid || static_cast<std::int32_t>(face) < opened.solid->inner_begin) return -1;
  const std::int32_t v = opened.vertex_of[opened.mesh.triangles[face][corner]];
  for (int i = 0; i < 3; ++i) {
    const std::int32_t h = 3 * opened.beside[face] + i;
    if (cut.root(cut.from(h)) == cut.root(v)) return h;
  }
  return -1;
}

SurfaceMesh opened_attributes(const SurfaceMesh& cut_surface, const TriangleMesh& cut,
                              const OpenedMesh& opened) {
  SurfaceMesh result;
  result.metres_per_unit = cut_surface.metres_per_unit;
  result.positions = opened.mesh.positions;
  result.triangles = opened.mesh.triangles;
  const std::size_t faces = opened.beside.size();

  const bool normals = !cut_surface.corner_normals.empty();
  for (std::size_t f = 0; f < faces; ++f) {
    for (int i = 0; i < 3; ++i) {
      const std::int32_t above = corner_above(cut, opened, f, i);
      const std::int32_t source = corner_source(cut, opened, f, i, above);
      if (!cut_surface.corner_uvs.empty()) {
        result.corner_uvs.push_back(cut_surface.corner_uvs[source]);
      }
      if (!normals) continue;
      if (opened.face_of[f] >= 0) {
        result.corner_normals.push_back(cut_surface.corner_normals[source]);
      } else if (above >= 0) {
        const bool is_core = static_cast<std::int32_t>(f) >= opened.solid->core_begin;
        result.corner_normals.push_back((is_core ? 1 : -1) * cut_surface.corner_normals[above]);
      } else {
        result.corner_normals.push_back(face_normal(result, f));
      }
    }
  }
  for (const std::int32_t v : opened.vertex_of) {
    if (!cut_surface.vertex_colors.empty()) {
      result.vertex_colors.push_back(cut_surface.vertex_colors[v]);
    }
  }
  for (const Attribute& a : cut_surface.vertex_attributes) {
    result.vertex_attributes.push_back(pick(a, opened.vertex_of));
  }
  for (const Attribute& a : cut_surface.face_attributes) {
    result.face_attributes.push_back(pick(a, opened.beside));
    if (a.name == "fragment") number_cores(opened, result.face_attributes.back());
    if (a.name != "source_face") continue;
    for (std::size_t f = 0; f < faces; ++f) {
      if (opened.face_of[f] < 0) result.face_attributes.back().values[f] = -1;
    }
  }
  for (std::size_t f = 0; f < faces; ++f) {
    result.source_faces.push_back(
        opened.face_of[f] < 0 ? -1 : cut_surface.source_faces[opened.beside[f]]);
  }
  result.object_names = cut_surface.object_names;
  for (const std::int32_t f : opened.beside) {
    if (!cut_surface.face_objects.empty()) {
      result.face_objects.push_back(cut_surface.face_objects[f]);
    }
  }
  const bool any_wall =
      std::find(opened.face_of.begin(), opened.face_of.end(), -1) != opened.face_of.end();
  if (any_wall || !cut_surface.face_materials.empty()) {
    add_materials(result, cut_surface, opened);
  }
  return result;
}

}  // namespace craze
