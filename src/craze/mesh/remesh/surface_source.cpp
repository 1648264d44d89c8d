#include "craze/mesh/remesh/surface_source.h"

#include <cstddef>

namespace craze {

namespace {

using Pairs = std::vector<std::array<std::int32_t, 2>>;

// The means of pairs of old values. An exact copy where both are the same.
template <class T, class Mean>
std::vector<T> gather(const std::vector<T>& old, const Pairs& pairs, Mean&& mean) {
  std::vector<T> values;
  if (old.empty()) return values;
  values.reserve(pairs.size());
  for (const auto& [a, b] : pairs) values.push_back(a == b ? old[a] : mean(old[a], old[b]));
  return values;
}

template <class T>
std::vector<T> gather(const std::vector<T>& old, const std::vector<std::int32_t>& indices) {
  std::vector<T> values;
  if (old.empty()) return values;
  values.reserve(indices.size());
  for (std::int32_t i : indices) values.push_back(old[i]);
  return values;
}

}  // namespace

SurfaceMesh transfer(const SurfaceMesh& old, std::vector<Triangle> triangles,
                     const SurfaceSource& source) {
  SurfaceMesh made;
  made.metres_per_unit = old.metres_per_unit;
  made.triangles = std::move(triangles);
  made.positions = gather(old.positions, source.vertices,
                          [](const Vec3& a, const Vec3& b) -> Vec3 { return 0.5 * (a + b); });
  made.corner_uvs = gather(old.corner_uvs, source.corners,
                           [](const Vec2& a, const Vec2& b) -> Vec2 { return 0.5 * (a + b); });
  made.corner_normals =
      gather(old.corner_normals, source.corners,
             [](const Vec3& a, const Vec3& b) -> Vec3 { return (a + b).normalized(); });
  made.vertex_colors =
      gather(old.vertex_colors, source.vertices, [](const Color& a, const Color& b) {
        Color mean;
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5f * (a[i] + b[i]);
        return mean;
      });
  made.face_materials = gather(old.face_materials, source.faces);
  made.material_names = old.material_names;
  made.face_objects = gather(old.face_objects, source.faces);
  made.object_names = old.object_names;
  made.source_faces =
      old.source_faces.empty() ? source.faces : gather(old.source_faces, source.faces);
  for (const Attribute& a : old.vertex_attributes) {
    Attribute& b = made.vertex_attributes.emplace_back(Attribute{a.name, a.components, {}});
    for (const auto& [v, w] : source.vertices) {
      for (int i = 0; i < a.components; ++i) {
        b.values.push_back(
            v == w ? a.values[v * a.components + i]
                   : 0.5 * (a.values[v * a.components + i] + a.values[w * a.components + i]));
      }
    }
  }
  for (const Attribute& a : old.face_attributes) {
    Attribute& b = made.face_attributes.emplace_back(Attribute{a.name, a.components, {}});
    for (std::int32_t f : source.faces) {
      for (int i = 0; i < a.components; ++i) b.values.push_back(a.values[f * a.components + i]);
    }
  }
  if (!made.corner_normals.empty()) {
    for (std::size_t f = 0; f < made.triangles.size(); ++f) {
      if (!source.flipped[f]) continue;
      const Triangle& t = made.triangles[f];
      const Vec3 n = (made.positions[t[1]] - made.positions[t[0]])
                         .cross(made.positions[t[2]] - made.positions[t[0]]);
      for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
        if (made.corner_normals[c].dot(n) < 0) made.corner_normals[c] = -made.corner_normals[c];
      }
    }
  }
  return made;
}

}  // namespace craze
