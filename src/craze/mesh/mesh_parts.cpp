#include "craze/mesh/mesh_parts.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

#include "craze/error.h"

namespace craze {

namespace {

template <class T>
std::vector<T> pick(const std::vector<T>& source, const std::vector<std::int32_t>& from) {
  std::vector<T> result;
  if (source.empty()) return result;
  result.reserve(from.size());
  for (const std::int32_t i : from) result.push_back(source[i]);
  return result;
}

}  // namespace

const Attribute& part_numbers(const SurfaceMesh& mesh, const std::string& attribute) {
  const Attribute* values = find_attribute(mesh.face_attributes, attribute);
  if (values && values->components == 1) return *values;
  throw Error(ErrorKind::request, "cannot write the mesh as objects", attribute,
              "the faces have no such number");
}

std::vector<MeshPart> mesh_parts(const SurfaceMesh& mesh, const std::string& attribute) {
  const Attribute& values = part_numbers(mesh, attribute);
  std::map<double, std::vector<std::int32_t>> faces_of;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    faces_of[values.values[f]].push_back(static_cast<std::int32_t>(f));
  }
  std::vector<MeshPart> parts;
  parts.reserve(faces_of.size());
  for (auto& [value, faces] : faces_of) {
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%g", value);
    parts.push_back({attribute + "_" + number.data(), std::move(faces)});
  }
  return parts;
}

ExtractedPart extract_part(const SurfaceMesh& mesh, const std::vector<std::int32_t>& faces) {
  ExtractedPart part;
  for (const std::int32_t f : faces) {
    part.vertices.insert(part.vertices.end(), mesh.triangles[f].begin(), mesh.triangles[f].end());
  }
  std::sort(part.vertices.begin(), part.vertices.end());
  part.vertices.erase(std::unique(part.vertices.begin(), part.vertices.end()), part.vertices.end());
  SurfaceMesh& result = part.mesh;
  result.metres_per_unit = mesh.metres_per_unit;
  result.positions = pick(mesh.positions, part.vertices);
  result.vertex_colors = pick(mesh.vertex_colors, part.vertices);
  result.face_materials = pick(mesh.face_materials, faces);
  result.face_objects = pick(mesh.face_objects, faces);
  result.source_faces = pick(mesh.source_faces, faces);
  result.material_names = mesh.material_names;
  result.object_names = mesh.object_names;
  for (const Attribute& a : mesh.vertex_attributes) {
    result.vertex_attributes.push_back(pick(a, part.vertices));
  }
  for (const Attribute& a : mesh.face_attributes) {
    result.face_attributes.push_back(pick(a, faces));
  }
  const auto index = [&](std::int32_t v) {
    return static_cast<std::int32_t>(
        std::lower_bound(part.vertices.begin(), part.vertices.end(), v) - part.vertices.begin());
  };
  for (const std::int32_t f : faces) {
    const Triangle& t = mesh.triangles[f];
    result.triangles.push_back({index(t[0]), index(t[1]), index(t[2])});
    for (std::size_t c = 3 * static_cast<std::size_t>(f); c < 3 * static_cast<std::size_t>(f) + 3;
         ++c) {
      if (!mesh.corner_uvs.empty()) result.corner_uvs.push_back(mesh.corner_uvs[c]);
      if (!mesh.corner_normals.empty()) result.corner_normals.push_back(mesh.corner_normals[c]);
    }
  }
  return part;
}

}  // namespace craze
