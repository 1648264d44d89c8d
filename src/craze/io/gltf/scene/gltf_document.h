// A glTF file as it stood, kept for being written again with its surface cracked.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "craze/io/gltf/gltf_accessor.h"
#include "craze/io/gltf/gltf_json.h"
#include "craze/io/mesh_source.h"
#include "craze/io/source_scene.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The document in messages.
inline const std::string document_name = "the scene";
/// Bytes between which any element may start.
inline constexpr std::size_t element_alignment = 16;
/// The first such place from `at` on.
inline std::size_t aligned(std::size_t at) {
  return (at + element_alignment - 1) / element_alignment * element_alignment;
}

/// The triangles of one primitive, shown by one node (or one instance of it).
struct GltfPart {
  std::int32_t first_face = 0, end_face = 0;  ///< of the mesh that was read
  std::int32_t first_vertex = 0;              ///< the mesh's vertex that is the primitive's first
  std::size_t node = 0, mesh = 0, primitive = 0;
  std::int32_t object = -1;         ///< of the mesh that was read: the node's
  std::optional<std::size_t> copy;  ///< of a node that EXT_mesh_gpu_instancing shows many times
  std::optional<std::size_t> skin;  ///< which places the vertices instead of `transform`
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  bool mirrored = false;  ///< the mesh has the last two corners of each triangle swapped
};

/// The file as one document with one buffer: other buffers are joined to it, pictures outside the
/// file moved in, and a file without nodes has been given one for each mesh. Everything else is as
/// the file has it.
class GltfDocument : public SourceScene {
 public:
  GltfDocument(Json root, std::string bin, std::vector<GltfPart> parts, const SurfaceMesh& mesh);

  std::vector<SceneContent> contents() const override;
  int color_bits() const override;
  /// Of the nodes above, and of the mesh.
  std::vector<OtherName> other_names() const override;

  const Json& root() const { return root_; }
  const std::string& bin() const { return bin_; }
  /// By first face, which follow each other without gaps.
  const std::vector<GltfPart>& parts() const { return parts_; }
  std::size_t part_of(std::int32_t face) const;
  /// #F and #V of the mesh that was read.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Vec3>& positions() const { return positions_; }
  /// The names of the mesh's vertex attributes.
  const std::vector<std::string>& attributes() const { return attributes_; }

 private:
  Json root_;
  std::string bin_;
  std::vector<GltfPart> parts_;
  std::vector<Triangle> triangles_;
  std::vector<Vec3> positions_;
  std::vector<std::string> attributes_, objects_;
};

/// Keeps what was read. Null, with a warning, where a part of it cannot be brought; a picture that
/// cannot be keeps its name, with a warning.
std::shared_ptr<const GltfDocument> keep_document(Json root, GltfAccessors& accessors,
                                                  std::vector<GltfPart> parts,
                                                  const SurfaceMesh& mesh,
                                                  const MeshSource& source);

}  // namespace craze
