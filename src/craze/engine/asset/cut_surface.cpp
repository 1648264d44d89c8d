#include "craze/engine/asset/cut_surface.h"

#include <algorithm>

namespace craze {

namespace {

constexpr double cancelled = 1e-9;  // a normal shorter than this is the sum of opposite ones

/// 3 #F values, each corner of a part set to make(asset face, weights).
template <class T, class Make>
std::vector<T> corner_values(const std::vector<T>& old, const CutAsset& cut, Make&& make) {
  if (old.empty()) return {};
  std::vector<T> values;
  values.reserve(3 * cut.face_source.size());
  values.assign(old.begin(), old.end());
  values.resize(3 * cut.face_source.size());
  for (std::size_t p = 0; p < cut.parts.size(); ++p) {
    const std::size_t face = cut.parts[p];
    for (std::size_t i = 0; i < 3; ++i) {
      values[3 * face + i] = make(cut.face_source[face], cut.part_weights[3 * p + i]);
    }
  }
  return values;
}

Vec3 normal_at(const SurfaceMesh& asset, std::int32_t f, const Vec3& weights) {
  const auto value = [&](int i) -> Vec3 { return asset.corner_normals[3 * std::size_t(f) + i]; };
  const Vec3 n = interpolate_corners(weights, value);
  int nearest = 0;
  if (weights.maxCoeff(&nearest) == 1) return n;
  return n.norm() > cancelled ? Vec3(n.normalized()) : value(nearest);
}

Attribute vertex_attribute(const SurfaceMesh& asset, const Attribute& old, const CutAsset& cut) {
  Attribute made{old.name, old.components, {}};
  made.values.reserve(cut.root.size() * static_cast<std::size_t>(old.components));
  made.values.assign(old.values.begin(), old.values.end());
  for (const SurfacePoint& at : cut.new_vertices) {
    const Triangle& t = asset.triangles[at.face];
    for (int k = 0; k < old.components; ++k) {
      made.values.push_back(interpolate_corners(at.weights, [&](int i) -> double {
        return old.values[static_cast<std::size_t>(t[i]) * old.components + k];
      }));
    }
  }
  return made;
}

std::vector<Color> vertex_colors(const SurfaceMesh& asset, const CutAsset& cut) {
  if (asset.vertex_colors.empty()) return {};
  std::vector<Color> colors;
  colors.reserve(cut.root.size());
  colors.assign(asset.vertex_colors.begin(), asset.vertex_colors.end());
  for (const SurfacePoint& at : cut.new_vertices) {
    const Triangle& t = asset.triangles[at.face];
    Color& color = colors.emplace_back();
    for (std::size_t k = 0; k < color.size(); ++k) {
      color[k] = static_cast<float>(interpolate_corners(
          at.weights, [&](int i) -> double { return asset.vertex_colors[t[i]][k]; }));
    }
  }
  return colors;
}

/// A value for each face: the asset's own, then those of the faces that the new ones come from.
template <class T>
std::vector<T> face_values(const std::vector<T>& old, const CutAsset& cut) {
  if (old.empty()) return {};
  std::vector<T> values;
  values.reserve(cut.face_source.size());
  values.assign(old.begin(), old.end());
  for (std::size_t f = old.size(); f < cut.face_source.size(); ++f) {
    values.push_back(old[cut.face_source[f]]);
  }
  return values;
}

}  // namespace

SurfaceMesh cut_surface(const SurfaceMesh& asset, const CutAsset& cut,
                        const std::vector<Vec3>& positions,
                        const std::vector<Triangle>& triangles) {
  SurfaceMesh result;
  result.metres_per_unit = asset.metres_per_unit;
  result.positions = positions;
  result.triangles = triangles;
  result.corner_uvs =
      corner_values(asset.corner_uvs, cut, [&](std::int32_t f, const Vec3& weights) -> Vec2 {
        return interpolate_corners(
            weights, [&](int i) -> Vec2 { return asset.corner_uvs[3 * std::size_t(f) + i]; });
      });
  result.corner_normals = corner_values(
      asset.corner_normals, cut,
      [&](std::int32_t f, const Vec3& weights) -> Vec3 { return normal_at(asset, f, weights); });
  result.vertex_colors = vertex_colors(asset, cut);
  for (const Attribute& a : asset.vertex_attributes) {
    result.vertex_attributes.push_back(vertex_attribute(asset, a, cut));
  }
  for (const Attribute& a : asset.face_attributes) {
    result.face_attributes.push_back(pick(a, cut.face_source));
  }
  result.face_materials = face_values(asset.face_materials, cut);
  result.material_names = asset.material_names;
  result.face_objects = face_values(asset.face_objects, cut);
  result.object_names = asset.object_names;
  result.source_faces =
      asset.source_faces.empty() ? cut.face_source : face_values(asset.source_faces, cut);
  return result;
}

}  // namespace craze
