#include <map>
#include <tuple>

#include "craze/io/gltf/glb_mesh.h"
#include "craze/io/gltf/scene/crack_primitives.h"
#include "craze/io/gltf/scene/scene_growth.h"

namespace craze {

namespace {

bool is_of_walls(const std::string& name) {
  return name != "NORMAL" && name != "TANGENT" && !name.starts_with("COLOR_");
}

}  // namespace

Json wall_primitive(const PrimitiveSource& source, const std::vector<std::int32_t>& walls,
                    std::size_t material, const SceneGrowth* growth, SceneOutput& output) {
  const auto& [cut, primitive, place, accessors] = source;
  const SurfaceMesh& mesh = cut.mesh();
  const bool has_normals = !mesh.corner_normals.empty();
  using Key = std::tuple<std::int32_t, std::array<std::uint32_t, 3>, std::array<double, 3>>;
  std::map<Key, std::uint32_t> numbers;
  std::vector<CutVertices::Vertex> corners;
  std::vector<Vec3> normals;
  std::vector<std::uint32_t> indices;
  for (const std::int32_t f : walls) {
    for (const int i : place.part.mirrored ? std::array{0, 2, 1} : std::array{0, 1, 2}) {
      const std::int32_t v = mesh.triangles[f][static_cast<std::size_t>(i)];
      const VertexBlend blend = cut.blend(place.part, f, i);
      const Vec3 n =
          has_normals
              ? mesh.corner_normals[3 * static_cast<std::size_t>(f) + static_cast<std::size_t>(i)]
              : Vec3(0, 0, 0);
      const auto [found, is_new] = numbers.try_emplace(Key{v, blend.from, {n.x(), n.y(), n.z()}},
                                                       static_cast<std::uint32_t>(corners.size()));
      if (is_new) {
        corners.push_back({blend, v});
        normals.push_back(n);
      }
      indices.push_back(found->second);
    }
  }
  PrimitiveVertices vertices(primitive, place, accessors, is_of_walls);
  const std::size_t old = vertices.count();
  vertices.append(cut, corners);
  vertices.drop(old);
  vertices.complete_targets();
  if (has_normals) vertices.set_normals(normals);
  std::vector<std::int32_t> owner;
  for (const CutVertices::Vertex& corner : corners) owner.push_back(corner.of);
  if (growth) growth->add_targets(vertices, owner);
  Json made{{"attributes", vertices.write_attributes(output)},
            {"indices", output.add_indices(indices, vertices.count(), 0)},
            {"material", material}};
  if (Json targets = vertices.write_targets(output); !targets.empty()) {
    made["targets"] = std::move(targets);
  }
  return made;
}

void add_crack_attributes(const CutScene& cut, const std::vector<std::int32_t>& owner,
                          PrimitiveVertices& vertices) {
  const std::vector<std::string>& known = cut.document().attributes();
  for (const Attribute& a : cut.mesh().vertex_attributes) {
    const bool is_old = std::find(known.begin(), known.end(), a.name) != known.end();
    if (is_old || a.components > 4) continue;
    GltfElements elements;
    elements.components = static_cast<std::size_t>(a.components);
    constexpr double nowhere[] = {-1, -1, -1, -1};
    for (const std::int32_t v : owner) {
      elements.append(v < 0 ? nowhere
                            : &a.values[static_cast<std::size_t>(v) * elements.components]);
    }
    vertices.set(glb_attribute_name(a.name), std::move(elements));
  }
}

}  // namespace craze
