// Faces of the cut mesh as a primitive of their own.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/io/gltf/scene/crack_primitives.h"
#include "craze/io/gltf/scene/scene_growth.h"

namespace craze {

/// Some faces of a part, or side walls beside it, with vertices of their own, which have what those
/// of the primitive have that the faces lie in: placed, textured and moved as it. Walls have
/// normals of their own, and neither tangents nor colours.
class LoosePrimitive {
 public:
  enum class Kind { faces, walls };

  /// `source` must outlive this. bent: normals are those of the cut mesh (MeshFileOptions::bent).
  LoosePrimitive(const PrimitiveSource& source, const std::vector<std::int32_t>& faces, Kind kind,
                 bool bent);

  /// Some of its triangles by themselves.
  LoosePrimitive picked(const std::vector<std::size_t>& triangles) const;

  const std::vector<std::uint32_t>& indices() const { return indices_; }
  const PrimitiveVertices& vertices() const { return vertices_; }
  PrimitiveVertices& vertices() { return vertices_; }
  /// Appends the targets of a clip.
  void add_targets(const SceneGrowth& growth) { growth.add_targets(vertices_, owner_); }
  /// As a primitive; of the kind `faces` with all else that the document's has.
  Json write(SceneOutput& output) const;

 private:
  LoosePrimitive(const LoosePrimitive& from, const std::vector<std::size_t>& vertices);

  const Json& primitive_;
  Kind kind_;
  PrimitiveVertices vertices_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::int32_t> owner_;  // the cut mesh's vertex
};

}  // namespace craze
