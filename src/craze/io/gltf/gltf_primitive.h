// The vertices of one primitive as the file shows them: morph targets mixed in.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "craze/io/gltf/gltf_accessor.h"
#include "craze/io/gltf/gltf_json.h"

namespace craze {

/// The weights of a mesh's targets: the node's, which may be null, win over the mesh's.
std::vector<double> morph_weights(const Json& mesh, const Json* node, const GltfJson& json);

/// What a primitive is drawn as: LINES.
inline constexpr int lines_mode = 1;

/// Of a primitive.
inline std::size_t target_count(const Json& primitive) {
  const auto targets = primitive.find("targets");
  return targets == primitive.end() ? 0 : targets->size();
}

/// In a primitive's extras: its triangles draw cracks and are no surface.
inline constexpr const char* crack_lines_mark = "crack_lines";
inline bool draws_cracks(const Json& primitive) {
  const auto extras = primitive.find("extras");
  return extras != primitive.end() && extras->is_object() &&
         extras->value(crack_lines_mark, Json()) == Json(true);
}

/// What stands for a number of an attribute that is not finite.
inline double mended_number(std::string_view key) {
  return key.starts_with("COLOR_") || key == "TANGENT" ? 1 : 0;
}

/// Attributes by name, with the default weights of the targets applied.
class GltfPrimitive {
 public:
  /// All must outlive this. `weights`: the node's or the mesh's, one per target; those missing are
  /// 0. `spend` is told how many vertices are placed or moved. Throws
  /// Error(input).
  GltfPrimitive(const Json& primitive, const std::vector<double>& weights, GltfAccessors& accessors,
                std::function<void(std::size_t)> spend, const std::string& name);

  const Json& attributes() const { return *attributes_; }
  bool has(const char* key) const { return attributes_->contains(key); }
  /// As the accessor of POSITION says.
  std::size_t vertex_count() const { return count_; }
  /// What tells primitives apart whose vertices differ.
  std::string key() const;
  /// Numbers that are not finite are mended, but for POSITION. Throws Error(input) for those, and
  /// where the accessor has not one element per vertex, or neither number of
  /// components.
  GltfAccessors::Values read(const char* key, std::size_t components, std::size_t or_components);

 private:
  GltfAccessors::Values read_accessor(const Json& attributes, const char* key);

  const Json* attributes_;
  const Json* targets_;
  const std::vector<double>& weights_;
  GltfAccessors& accessors_;
  std::function<void(std::size_t)> spend_;
  GltfJson json_;
  std::size_t count_ = 0;
};

}  // namespace craze
