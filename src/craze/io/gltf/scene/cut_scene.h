// A kept document together with the cut mesh that was made of its surface.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/io/gltf/scene/cut_vertices.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/surface_mesh.h"
#include "craze/surface_origin.h"

namespace craze {

/// What the cut mesh has of one part of the document.
struct PartFaces {
  std::vector<std::int32_t> faces;  ///< by the document's triangle
  std::vector<std::int32_t> walls;
  std::vector<std::int32_t> crack_edges;  ///< halfedges 3f+i along shut cracks, one a crack
  bool is_changed = false;                ///< cut, moved, with walls, or to be written anew
};

class CutScene {
 public:
  /// All must outlive this. crack_edges: halfedges 3f+i of the mesh, faces below the walls.
  /// is_apart: every part of which the mesh has something counts as changed.
  CutScene(const GltfDocument& document, const SurfaceMesh& mesh, const SurfaceOrigin& origin,
           const std::vector<std::int32_t>& crack_edges, bool is_apart);

  const GltfDocument& document() const { return document_; }
  const SurfaceMesh& mesh() const { return mesh_; }
  /// By the document's parts.
  const std::vector<PartFaces>& parts() const { return parts_; }

  /// Where corner i of a face lies among the vertices of its part's primitive.
  VertexBlend blend(const GltfPart& part, std::int32_t face, int i) const;
  /// The same of a vertex of the primitive that is itself.
  static VertexBlend itself(std::uint32_t vertex);
  /// A triangle of the document, as the file turns it, by vertices of its primitive.
  std::array<std::uint32_t, 3> triangle(const GltfPart& part, std::int32_t face) const;
  /// A face's corners in the order in which the file turns its triangle.
  std::array<int, 3> order(const GltfPart& part, std::int32_t face) const;
  std::int32_t source(std::int32_t face) const { return origin_.face[face]; }

  /// How far the cut mesh has moved that vertex from its place at `blend`, in the scene; zero where
  /// single precision would not hold it.
  Vec3 shift(const GltfPart& part, const VertexBlend& blend, std::int32_t vertex) const;

 private:
  std::array<std::uint32_t, 3> read_triangle(const GltfPart& part, std::int32_t face) const;
  bool is_changed(const GltfPart& part, const PartFaces& faces) const;
  /// Whether the mesh has vertex attributes that neither the document has nor a run adds.
  bool has_new_attributes() const;

  const GltfDocument& document_;
  const SurfaceMesh& mesh_;
  const SurfaceOrigin& origin_;
  double unnoticed_;  // length
  std::vector<PartFaces> parts_;
};

}  // namespace craze
