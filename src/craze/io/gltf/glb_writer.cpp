// Format: Khronos Group, "glTF 2.0 Specification", 2021.
#include "craze/io/gltf/gltf.h"
#include "craze/mesh/morph_animation.h"

#include <nlohmann/json.hpp>

#include "craze/io/gltf/glb_buffer.h"
#include "craze/io/gltf/glb_mesh.h"
#include "craze/io/polygons/float_grid.h"
#include "craze/io/polygons/polygon_soup.h"
#include "craze/mesh/mesh_parts.h"

namespace craze {

namespace {

using nlohmann::ordered_json;

/// Seconds that the clip waits before and after, so that a loop shows both ends.
constexpr double wait_before = 0.25, wait_after = 1;

ordered_json to_json(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

class GlbWriter {
 public:
  GlbWriter(const MeshFileOptions& options, const Context& context)
      : options_(options), context_(context) {}

  std::string write(const SurfaceMesh& mesh) {
    const Vec3 far = far_origin(mesh);
    if (options_.objects.empty()) {
      ordered_json node{{"mesh", 0}};
      if (!far.isZero(0)) node["translation"] = to_json(far);
      add_node(std::move(node), mesh, far,
               options_.animation ? options_.animation->stages : std::vector<MorphStage>{});
    } else if (far.isZero(0)) {
      add_parts(mesh);
    } else {
      SurfaceMesh near = mesh;
      for (Vec3& p : near.positions) p -= far;
      add_parts(near);
    }
    ordered_json root;
    root["asset"] = {{"version", "2.0"}, {"generator", "craze"}};
    root["scene"] = 0;
    root["scenes"] = {{{"nodes", ordered_json::array()}}};
    ordered_json all = ordered_json::array();
    for (std::size_t i = 0; i < nodes_.size(); ++i) all.push_back(i);
    root["nodes"] = nodes_;
    if (!options_.objects.empty() && !far.isZero(0)) {
      // Parts that meet still meet below one node, whatever precision its place is given in.
      root["scenes"][0]["nodes"].push_back(nodes_.size());
      root["nodes"].push_back({{"translation", to_json(far)}, {"children", std::move(all)}});
    } else {
      root["scenes"][0]["nodes"] = std::move(all);
    }
    root["meshes"] = meshes_;
    root["materials"] = materials_.json();
    if (options_.animation) root["animations"] = ordered_json::array({animation()});
    return buffer_.pack(root);
  }

 private:
  void add_node(ordered_json node, const SurfaceMesh& mesh, const Vec3& origin,
                const std::vector<MorphStage>& stages) {
    if (context_.is_cancelled()) throw Cancelled();
    nodes_.push_back(std::move(node));
    meshes_.push_back(glb_mesh(mesh, origin, stages, buffer_, materials_, context_));
  }

  void add_parts(const SurfaceMesh& mesh) {
    const double grid = float_grid(mesh);
    for (const MeshPart& part : mesh_parts(mesh, options_.objects)) {
      ExtractedPart own = extract_part(mesh, part.faces);
      const Vec3 origin = on_grid(centroid(own.mesh), grid);
      for (Vec3& p : own.mesh.positions) p = on_grid(p, grid);
      ordered_json node{
          {"name", part.name}, {"mesh", meshes_.size()}, {"translation", to_json(origin)}};
      add_node(std::move(node), own.mesh, origin,
               options_.animation ? stages_of(*options_.animation, own.vertices)
                                  : std::vector<MorphStage>{});
    }
  }

  /// Each stage's weight goes from 1 to 0 while the stage lasts.
  ordered_json animation() {
    const std::size_t stages = options_.animation->stages.size();
    std::vector<float> keys, weights;
    const auto add_key = [&](double seconds, std::size_t stages_done) {
      keys.push_back(static_cast<float>(seconds));
      for (std::size_t k = 0; k < stages; ++k) weights.push_back(k < stages_done ? 0.0f : 1.0f);
    };
    const double each = options_.animation->seconds / static_cast<double>(stages);
    add_key(0, 0);
    for (std::size_t k = 0; k <= stages; ++k) {
      add_key(wait_before + static_cast<double>(k) * each, k);
    }
    add_key(wait_before + options_.animation->seconds + wait_after, stages);
    ordered_json json{{"name", "growth"}, {"channels", ordered_json::array()}};
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      json["channels"].push_back(
          {{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}});
    }
    const std::size_t input = buffer_.add_keys(keys);
    json["samplers"] = {{{"input", input},
                         {"interpolation", "LINEAR"},
                         {"output", buffer_.add_floats(weights, 1, GlbBuffer::Target::none)}}};
    return json;
  }

  const MeshFileOptions& options_;
  const Context& context_;
  GlbBuffer buffer_;
  GlbMaterials materials_;
  ordered_json nodes_ = ordered_json::array(), meshes_ = ordered_json::array();
};

}  // namespace

std::string format_glb(const SurfaceMesh& mesh, const MeshFileOptions& options,
                       const Context& context) {
  if (mesh.corner_normals.empty()) return GlbWriter(options, context).write(mesh);
  SurfaceMesh unit = mesh;
  normalize_corner_normals(unit);
  return GlbWriter(options, context).write(unit);
}

}  // namespace craze
