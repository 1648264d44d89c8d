#include "craze/io/gltf/scene/loose_primitive.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace craze {

namespace {

bool is_of_walls(const std::string& name) {
  return name != "NORMAL" && name != "TANGENT" && !name.starts_with("COLOR_");
}

}  // namespace

LoosePrimitive::LoosePrimitive(const PrimitiveSource& source,
                               const std::vector<std::int32_t>& faces, Kind kind, bool bent)
    : primitive_(source.primitive),
      kind_(kind),
      vertices_(source.primitive, source.place, source.accessors, [kind](const std::string& name) {
        return kind == Kind::faces || is_of_walls(name);
      }) {
  const auto& [cut, primitive, place, accessors] = source;
  const SurfaceMesh& mesh = cut.mesh();
  const bool is_wall = kind == Kind::walls, has_normals = !mesh.corner_normals.empty();
  using Key = std::tuple<std::int32_t, std::array<std::uint32_t, 3>, std::array<double, 3>>;
  std::map<Key, std::uint32_t> numbers;
  std::vector<CutVertices::Vertex> corners;
  std::vector<Vec3> normals;
  for (const std::int32_t f : faces) {
    const std::array<int, 3> wall_order =
        place.part.mirrored ? std::array{0, 2, 1} : std::array{0, 1, 2};
    for (const int i : is_wall ? wall_order : cut.order(place.part, f)) {
      const std::int32_t v = mesh.triangles[f][static_cast<std::size_t>(i)];
      const VertexBlend blend = cut.blend(place.part, f, i);
      Vec3 n = Vec3::Zero();
      if (has_normals) {
        n = mesh.corner_normals[3 * static_cast<std::size_t>(f) + static_cast<std::size_t>(i)];
      }
      // What a primitive parts, its own vertices part already.
      Vec3 parts = Vec3::Zero();
      if (is_wall) parts = n;
      const auto [found, is_new] =
          numbers.try_emplace(Key{v, blend.from, {parts.x(), parts.y(), parts.z()}},
                              static_cast<std::uint32_t>(corners.size()));
      if (is_new) {
        corners.push_back({blend, v});
        owner_.push_back(v);
        normals.push_back(n);
      }
      indices_.push_back(found->second);
    }
  }
  const std::size_t old = vertices_.count();
  vertices_.append(cut, corners);
  vertices_.drop(old);
  if (is_wall) {
    vertices_.complete_targets();
    if (has_normals) vertices_.set_normals(normals);
    return;
  }
  add_crack_attributes(cut, owner_, vertices_);
  if (!bent || !has_normals || !vertices_.has_normals()) return;
  for (std::size_t k = 0; k < normals.size(); ++k) vertices_.turn_normal(k, normals[k]);
}

LoosePrimitive::LoosePrimitive(const LoosePrimitive& from, const std::vector<std::size_t>& vertices)
    : primitive_(from.primitive_), kind_(from.kind_), vertices_(from.vertices_, vertices) {
  for (const std::size_t v : vertices) owner_.push_back(from.owner_[v]);
}

LoosePrimitive LoosePrimitive::picked(const std::vector<std::size_t>& triangles) const {
  std::vector<std::size_t> vertices;
  for (const std::size_t t : triangles) {
    for (std::size_t c = 3 * t; c < 3 * t + 3; ++c) vertices.push_back(indices_[c]);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  LoosePrimitive result(*this, vertices);
  for (const std::size_t t : triangles) {
    for (std::size_t c = 3 * t; c < 3 * t + 3; ++c) {
      const auto found = std::lower_bound(vertices.begin(), vertices.end(), indices_[c]);
      result.indices_.push_back(static_cast<std::uint32_t>(found - vertices.begin()));
    }
  }
  return result;
}

Json LoosePrimitive::write(SceneOutput& output) const {
  Json made = kind_ == Kind::faces ? primitive_ : Json::object();
  forget_form(made);
  made["attributes"] = vertices_.write_attributes(output);
  made["indices"] = output.add_indices(indices_, vertices_.count(), 0);
  made.erase("targets");
  if (Json targets = vertices_.write_targets(output); !targets.empty()) {
    made["targets"] = std::move(targets);
  }
  return made;
}

}  // namespace craze
