// Collects glTF primitives into one surface.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "craze/io/gltf/gltf_accessor.h"
#include "craze/io/gltf/gltf_primitive.h"
#include "craze/io/gltf/gltf_scene.h"
#include "craze/io/gltf/gltf_skin.h"
#include "craze/io/gltf/scene/gltf_document.h"
#include "craze/io/mesh_source.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Appends mesh after mesh to a surface. A file may show one mesh many times: `budget` is how many
/// elements it may expand to beyond twice the bytes that the accessors load.
class GltfBuilder {
 public:
  /// What looking at a primitive costs, counted in vertices.
  static constexpr std::size_t primitive_cost = 16;

  /// All must outlive this.
  GltfBuilder(const Json& root, GltfNodes& nodes, GltfAccessors& accessors,
              const MeshSource& source, std::size_t budget)
      : root_(root),
        nodes_(nodes),
        accessors_(accessors),
        json_(source.name),
        source_(source),
        budget_(budget) {}

  void add(const GltfInstance& instance);
  SurfaceMesh finish();
  /// Where the mesh's triangles come from, in their order.
  std::vector<GltfPart> take_parts() { return std::move(parts_); }

 private:
  using Values = GltfAccessors::Values;

  /// Vertices of one instance's primitives, by what they are made of.
  struct Placed {
    std::size_t first = 0;
    bool mirrored = false;  ///< turned inside out by what places them
    bool by_joints = false;
  };
  /// What places the vertices of a primitive: one matrix, or their joints.
  struct Placement {
    const Eigen::Matrix4d& whole;
    std::optional<GltfSkinning> joints;
  };

  /// The node, by number; the mesh where the file has no nodes.
  std::int32_t object_of(const GltfInstance& instance);
  /// Null where it has no triangles to give.
  const Placed* add_primitive(const Json& primitive, const GltfInstance& instance,
                              const std::vector<double>& weights,
                              std::map<std::string, Placed>& placed);
  void add_part(std::size_t first_face, const Placed& placed, std::size_t primitive,
                const GltfInstance& instance);
  Placed add_vertices(GltfPrimitive& primitive, const GltfInstance& instance);
  void add_normals(const Values& normals, const Placement& placement, std::size_t base);
  void add_colors(const Values& colors, std::size_t base);
  void add_attribute(const std::string& key, const Values& values, std::size_t base);
  void add_triangles(const std::vector<std::uint32_t>& indices, std::size_t mode, std::size_t base,
                     bool mirrored, std::int32_t material);
  const std::vector<Eigen::Matrix4d>& joints_of(std::size_t skin);
  void extend(Attribute& attribute, std::size_t vertices);
  void spend(std::size_t elements);
  void warn() const;

  const Json& root_;
  GltfNodes& nodes_;
  GltfAccessors& accessors_;
  GltfJson json_;
  const MeshSource& source_;
  std::size_t budget_, spent_ = 0;
  std::map<std::size_t, std::vector<Eigen::Matrix4d>> joints_;  ///< by skin
  std::map<std::size_t, std::int32_t> objects_;                 ///< by node, or mesh without
  std::int32_t object_ = -1;                                    ///< of the instance at hand
  std::vector<GltfPart> parts_;
  std::set<std::string> broken_keys_;  ///< attributes with numbers that were mended
  std::size_t left_over_ = 0, unknown_modes_ = 0;
  SurfaceMesh mesh_;
  std::vector<Vec2> uvs_;      ///< per vertex, as far as given
  std::vector<Vec3> normals_;  ///< per vertex, as far as given; zero: none
};

}  // namespace craze
