// Collects glTF primitives into one surface.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "craze/io/gltf/gltf_accessor.h"
#include "craze/io/gltf/gltf_scene.h"
#include "craze/mesh/surface_mesh.h"

namespace craze {

/// Appends mesh after mesh to a surface. A file may show one mesh many times: `budget` is how many
/// elements it may expand to beyond twice the bytes that the accessors load.
class GltfBuilder {
 public:
  /// All must outlive this.
  GltfBuilder(const Json& root, GltfAccessors& accessors, const std::string& name,
              std::size_t budget)
      : root_(root), accessors_(accessors), json_(name), name_(name), budget_(budget) {}

  void add(const GltfInstance& instance);
  SurfaceMesh finish();

 private:
  using Values = GltfAccessors::Values;

  void add_primitive(const Json& primitive, const Eigen::Matrix4d& world,
                     std::map<std::string, std::size_t>& first_vertices);
  void add_vertices(const Json& attributes, const Eigen::Matrix4d& world);
  void add_normals(const Values& normals, const Mat3& linear, std::size_t base);
  void add_colors(const Values& colors, std::size_t base);
  void add_attribute(const std::string& key, const Values& values, std::size_t base);
  void add_triangles(const std::vector<std::uint32_t>& indices, std::size_t mode, std::size_t base,
                     bool mirrored, std::int32_t material);
  Values read_attribute(const Json& attributes, const char* key, std::size_t count,
                        std::size_t components, std::size_t or_components);
  void extend(Attribute& attribute, std::size_t vertices);
  void spend(std::size_t elements);

  const Json& root_;
  GltfAccessors& accessors_;
  GltfJson json_;
  const std::string& name_;
  std::size_t budget_, spent_ = 0;
  SurfaceMesh mesh_;
  std::vector<Vec2> uvs_;      ///< per vertex, as far as given
  std::vector<Vec3> normals_;  ///< per vertex, as far as given; zero: none
};

}  // namespace craze
