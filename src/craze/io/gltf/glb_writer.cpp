// Format: Khronos Group, "glTF 2.0 Specification", 2021.
#include "craze/io/gltf/glb_writer.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "craze/io/gltf/glb_buffer.h"
#include "craze/io/gltf/glb_mesh.h"
#include "craze/io/polygons/mesh_parts.h"
#include "craze/io/polygons/polygon_soup.h"

namespace craze {

namespace {

using nlohmann::ordered_json;

/// Seconds that the clip waits before and after, so that a loop shows both ends.
constexpr double wait_before = 0.25, wait_after = 1;

/// Numbers on this grid, and differences of two of them, are exact in single precision.
double float_grid(const SurfaceMesh& mesh) {
  double most = 0;
  for (const Vec3& p : mesh.positions) most = std::max(most, p.cwiseAbs().maxCoeff());
  int exponent = 0;
  std::frexp(most, &exponent);
  return std::ldexp(1, exponent - 23);
}

Vec3 on_grid(const Vec3& p, double grid) {
  return (p / grid).array().round().matrix() * grid;
}

/// By area; by vertices where there is none.
Vec3 centroid(const SurfaceMesh& mesh) {
  Vec3 by_area = Vec3::Zero(), by_vertex = Vec3::Zero();
  double total = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const double area = (b - a).cross(c - a).norm();
    total += area;
    by_area += area * (a + b + c) / 3;
  }
  for (const Vec3& p : mesh.positions) by_vertex += p / static_cast<double>(mesh.positions.size());
  return total > 0 ? Vec3(by_area / total) : by_vertex;
}

/// The stages as a part sees them.
std::vector<MorphStage> stages_of(const MorphAnimation& animation,
                                  const std::vector<std::int32_t>& vertices) {
  std::vector<MorphStage> stages;
  for (const MorphStage& stage : animation.stages) {
    MorphStage& own = stages.emplace_back();
    std::size_t i = 0;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      while (i < stage.vertices.size() && stage.vertices[i] < vertices[v]) ++i;
      if (i == stage.vertices.size()) break;
      if (stage.vertices[i] != vertices[v]) continue;
      own.vertices.push_back(static_cast<std::int32_t>(v));
      own.shifts.push_back(stage.shifts[i]);
    }
  }
  return stages;
}

class GlbWriter {
 public:
  explicit GlbWriter(const GlbOptions& options) : options_(options) {}

  std::string write(const SurfaceMesh& mesh) {
    if (options_.objects.empty()) {
      add_node({{"mesh", 0}}, mesh, Vec3::Zero(),
               options_.animation ? options_.animation->stages : std::vector<MorphStage>{});
    } else {
      add_parts(mesh);
    }
    ordered_json root;
    root["asset"] = {{"version", "2.0"}, {"generator", "craze"}};
    root["scene"] = 0;
    root["scenes"] = {{{"nodes", ordered_json::array()}}};
    for (std::size_t i = 0; i < nodes_.size(); ++i) root["scenes"][0]["nodes"].push_back(i);
    root["nodes"] = nodes_;
    root["meshes"] = meshes_;
    root["materials"] = materials_.json();
    if (options_.animation) root["animations"] = ordered_json::array({animation()});
    return buffer_.pack(root);
  }

 private:
  void add_node(ordered_json node, const SurfaceMesh& mesh, const Vec3& origin,
                const std::vector<MorphStage>& stages) {
    nodes_.push_back(std::move(node));
    meshes_.push_back(glb_mesh(mesh, origin, stages, buffer_, materials_));
  }

  void add_parts(const SurfaceMesh& mesh) {
    const double grid = float_grid(mesh);
    for (const MeshPart& part : mesh_parts(mesh, options_.objects)) {
      ExtractedPart own = extract_part(mesh, part.faces);
      const Vec3 origin = on_grid(centroid(own.mesh), grid);
      for (Vec3& p : own.mesh.positions) p = on_grid(p, grid);
      ordered_json node{{"name", part.name},
                        {"mesh", meshes_.size()},
                        {"translation", {origin.x(), origin.y(), origin.z()}}};
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

  const GlbOptions& options_;
  GlbBuffer buffer_;
  GlbMaterials materials_;
  ordered_json nodes_ = ordered_json::array(), meshes_ = ordered_json::array();
};

}  // namespace

std::string format_glb(const SurfaceMesh& mesh, const GlbOptions& options) {
  if (mesh.corner_normals.empty()) return GlbWriter(options).write(mesh);
  SurfaceMesh unit = mesh;
  normalize_corner_normals(unit);
  return GlbWriter(options).write(unit);
}

}  // namespace craze
