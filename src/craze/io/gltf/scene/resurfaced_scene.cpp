#include "craze/io/gltf/scene/resurfaced_scene.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "craze/base/progress_meter.h"
#include "craze/io/gltf/first_uvs.h"
#include "craze/io/gltf/glb_mesh.h"
#include "craze/io/gltf/gltf_nodes.h"
#include "craze/io/gltf/gltf_primitive.h"
#include "craze/io/gltf/growth_clip.h"
#include "craze/io/gltf/line_lifts.h"
#include "craze/io/gltf/scene/scene_materials.h"
#include "craze/io/gltf/scene/scene_output.h"
#include "craze/io/gltf/scene/weight_channels.h"
#include "craze/io/gltf/solids/scene_solid.h"
#include "craze/io/gltf/solids/solid_node.h"
#include "craze/io/polygons/float_grid.h"
#include "craze/io/polygons/polygon_soup.h"
#include "craze/io/polygons/single_precision.h"
#include "craze/io/polygons/unify_corners.h"
#include "craze/mesh/mesh_parts.h"
#include "craze/mesh/morph_animation.h"

namespace craze {

namespace {

const Json bounded{{"min", 0}};

Json to_json(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

template <class Rows>
GltfElements floats(const Rows& rows, std::size_t components) {
  GltfElements elements;
  elements.components = components;
  for (const auto& row : rows) elements.append(row.data());
  return elements;
}

/// The mesh in the axes of a node.
void take_into(const Eigen::Matrix4d& world, SurfaceMesh& mesh) {
  const Eigen::Matrix4d inverse = world.inverse();
  const Mat3 linear = world.topLeftCorner<3, 3>();
  for (Vec3& p : mesh.positions) p = (inverse * p.homogeneous()).head<3>();
  for (Vec3& n : mesh.corner_normals) n = (linear.transpose() * n).stableNormalized();
  if (linear.determinant() > 0) return;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    std::swap(mesh.triangles[f][1], mesh.triangles[f][2]);
    if (!mesh.corner_uvs.empty()) std::swap(mesh.corner_uvs[3 * f + 1], mesh.corner_uvs[3 * f + 2]);
    if (mesh.corner_normals.empty()) continue;
    std::swap(mesh.corner_normals[3 * f + 1], mesh.corner_normals[3 * f + 2]);
  }
}

class Resurfacer {
 public:
  Resurfacer(const SurfaceMesh& mesh, const GltfDocument& document, const MeshFileOptions& options)
      : mesh_(mesh),
        document_(document),
        options_(options),
        output_(document),
        nodes_(document.root(), name_) {}

  std::string write(const Context& context) {
    std::map<std::int32_t, std::vector<std::int32_t>> faces_of;
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      faces_of[mesh_.face_objects[f]].push_back(static_cast<std::int32_t>(f));
    }
    std::map<std::int32_t, std::size_t> node_of;
    for (const GltfPart& part : document_.parts()) node_of[part.object] = part.node;
    forget_meshes();
    ProgressMeter meter(context, "write", faces_of.size(), 1);
    std::size_t done = 0;
    for (const auto& [object, faces] : faces_of) {
      meter.at(done++);
      show(node_of.at(object), extract_part(mesh_, faces));
    }
    if (options_.animation) add_growth();
    if (!options_.crack_edges.empty()) add_lines();
    if (output_.root["meshes"].empty()) output_.root.erase("meshes");
    return output_.pack();
  }

 private:
  /// Takes every mesh out of the scene, and what places or moves vertices.
  void forget_meshes() {
    Json& root = output_.root;
    root["meshes"] = Json::array();
    root.erase("skins");
    for (Json& node : root["nodes"]) {
      for (const char* key : {"mesh", "skin", "weights"}) node.erase(key);
      if (!node.contains("extensions")) continue;
      node["extensions"].erase("EXT_mesh_gpu_instancing");
      if (node["extensions"].empty()) node.erase("extensions");
    }
    output_.forget_extension("EXT_mesh_gpu_instancing");
    keep_first_uvs(root["materials"]);
    if (root["materials"].empty()) root.erase("materials");
    if (!root.contains("animations")) return;
    Json animations = Json::array();
    for (Json& animation : root["animations"]) {
      std::erase_if(animation["channels"].get_ref<Json::array_t&>(), [](const Json& channel) {
        const std::string pointer = animation_pointer(channel);
        return channel["target"].value("path", Json()) == Json("weights") ||
               moved_weights(channel) || pointer.starts_with("/meshes/") ||
               pointer.starts_with("/skins/");
      });
      if (!animation["channels"].empty()) animations.push_back(std::move(animation));
    }
    root["animations"] = std::move(animations);
    if (root["animations"].empty()) root.erase("animations");
  }

  /// Shows a part of the surface by a node.
  void show(std::size_t node, ExtractedPart shown) {
    SurfaceMesh& part = shown.mesh;
    MorphAnimation growth;
    if (options_.animation) growth.stages = stages_of(*options_.animation, shown.vertices);
    const Eigen::Matrix4d& world = nodes_.world(node);
    if (!(std::abs(world.topLeftCorner<3, 3>().determinant()) > 0)) {
      node = add_top_node({{"name", name_of(node)}});
    } else {
      take_into(world, part);
      const Mat3 inverse = world.topLeftCorner<3, 3>().inverse();
      for (MorphStage& stage : growth.stages) {
        for (Vec3& shift : stage.shifts) shift = inverse * shift;
      }
    }
    normalize_corner_normals(part);
    if (options_.objects.empty()) {
      output_.root["nodes"][node]["mesh"] = add_mesh(name_of(node), part, growth.stages);
      moving_.push_back(node);
      return;
    }
    const double grid = float_grid(part);
    for (const MeshPart& piece : mesh_parts(part, options_.objects)) {
      const ExtractedPart extracted = extract_part(part, piece.faces);
      SurfaceMesh own = extracted.mesh;
      const Vec3 middle = options_.solids ? solid_mass(own).centre : centroid(own);
      const Vec3 origin = on_grid(middle, grid);
      for (Vec3& p : own.positions) p = on_grid(p, grid) - origin;
      const std::size_t mesh = add_mesh(piece.name, own, stages_of(growth, extracted.vertices));
      Json& nodes = output_.root["nodes"];
      moving_.push_back(nodes.size());
      nodes[node]["children"].push_back(nodes.size());
      nodes.push_back({{"name", piece.name}, {"mesh", mesh}, {"translation", to_json(origin)}});
      if (options_.solids) add_solid(own, *options_.solids, nodes.size() - 1, output_);
    }
  }

  /// The number of a new node at the top of the scene.
  std::size_t add_top_node(Json node) {
    Json& root = output_.root;
    const std::size_t number = root["nodes"].size();
    root["nodes"].push_back(std::move(node));
    if (root.contains("scenes")) {
      root["scenes"][root.value("scene", std::size_t{0})]["nodes"].push_back(number);
    }
    return number;
  }

  std::string name_of(std::size_t node) const {
    return output_.root["nodes"][node].value("name", std::string());
  }

  /// As all but the stages that are to come have left it.
  Json targets(const std::vector<MorphStage>& stages, const UnifiedCorners& unified) {
    Json all = Json::array();
    for (const MorphStage& stage : stages) {
      GltfElements shifts;
      shifts.components = 3;
      for (const std::int32_t v : unified.sources) {
        const auto at = std::lower_bound(stage.vertices.begin(), stage.vertices.end(), v);
        Vec3 back = Vec3::Zero();
        if (at != stage.vertices.end() && *at == v)
          back -= stage.shifts[at - stage.vertices.begin()];
        static_cast<void>(to_floats(back, "GLB"));
        shifts.append(back.data());
      }
      all.push_back({{"POSITION", output_.add_sparse(shifts, &bounded)}});
    }
    return all;
  }

  /// The animation that plays the stages, of all that has them.
  void add_growth() {
    const GrowthClipKeys clip = growth_clip_keys(*options_.animation);
    const auto scalars = [](const std::vector<float>& numbers) {
      GltfElements elements;
      for (const double x : numbers) elements.append(&x);
      return elements;
    };
    Json animation{{"name", "growth"}, {"channels", Json::array()}};
    for (const std::size_t node : moving_) {
      animation["channels"].push_back(
          {{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}});
    }
    const std::size_t input = output_.add(scalars(clip.seconds), SceneOutput::Use::plain, &bounded);
    animation["samplers"] =
        Json::array({{{"input", input},
                      {"interpolation", "LINEAR"},
                      {"output", output_.add(scalars(clip.weights), SceneOutput::Use::plain)}}});
    Json& root = output_.root;
    if (!root.contains("animations")) root["animations"] = Json::array();
    root["animations"].push_back(std::move(animation));
  }

  std::size_t add_mesh(const std::string& name, const SurfaceMesh& part,
                       const std::vector<MorphStage>& stages) {
    const UnifiedCorners unified = unify_corners(part);
    Json attributes;
    const auto add = [&](const std::string& key, const GltfElements& elements, const Json* like) {
      attributes[key] = output_.add(elements, SceneOutput::Use::vertices, like);
    };
    std::vector<Vec3> positions;
    for (const std::int32_t v : unified.sources) {
      positions.push_back(part.positions[v]);
      static_cast<void>(to_floats(positions.back(), "GLB"));
    }
    add("POSITION", floats(positions, 3), &bounded);
    if (!unified.normals.empty()) add("NORMAL", floats(unified.normals, 3), nullptr);
    std::vector<Vec2> uvs;
    for (const Vec2& uv : unified.uvs) uvs.emplace_back(uv.x(), 1 - uv.y());
    if (!uvs.empty()) add("TEXCOORD_0", floats(uvs, 2), nullptr);
    std::vector<Eigen::Vector4d> colors;
    for (const std::int32_t v : unified.sources) {
      if (part.vertex_colors.empty()) break;
      Eigen::Vector4d& color = colors.emplace_back();
      for (int k = 0; k < 4; ++k) color[k] = std::clamp(part.vertex_colors[v][k], 0.0f, 1.0f);
    }
    if (!colors.empty()) add("COLOR_0", floats(colors, 4), nullptr);
    for (const Attribute& a : part.vertex_attributes) {
      for (const GlbColumns& columns : glb_columns(a)) {
        GltfElements elements;
        elements.components = static_cast<std::size_t>(columns.components);
        for (const std::int32_t v : unified.sources) {
          elements.append(
              &a.values[static_cast<std::size_t>(v) * static_cast<std::size_t>(a.components) +
                        static_cast<std::size_t>(columns.first)]);
        }
        add(columns.name, elements, nullptr);
      }
    }
    Json& meshes = output_.root["meshes"];
    Json mesh{{"primitives", primitives(part, unified, attributes)}};
    if (const Json moved = targets(stages, unified); !moved.empty()) {
      for (Json& primitive : mesh["primitives"]) primitive["targets"] = moved;
    }
    if (!name.empty()) mesh["name"] = name;
    meshes.push_back(std::move(mesh));
    return meshes.size() - 1;
  }

  Json primitives(const SurfaceMesh& part, const UnifiedCorners& unified, const Json& attributes) {
    std::map<std::int32_t, std::vector<std::uint32_t>> corners;  // by material
    for (std::size_t f = 0; f < part.triangles.size(); ++f) {
      auto& of = corners[part.face_materials.empty() ? -1 : part.face_materials[f]];
      for (const std::int32_t v : unified.triangles[f]) of.push_back(static_cast<std::uint32_t>(v));
    }
    Json all = Json::array();
    for (const auto& [material, indices] : corners) {
      Json primitive{{"attributes", attributes},
                     {"indices", output_.add_indices(indices, unified.sources.size(), 0)}};
      if (material >= 0) primitive["material"] = material_number(material);
      all.push_back(std::move(primitive));
    }
    return all;
  }

  /// Those of the document keep their numbers; beyond them there are walls.
  std::size_t material_number(std::int32_t material) {
    const auto number = static_cast<std::size_t>(material);
    const Json& root = document_.root();
    if (root.contains("materials") && number < root["materials"].size()) return number;
    if (!wall_) wall_ = add_wall_material(output_);
    return *wall_;
  }

  void add_lines() {
    const std::vector<Vec3> lifts = line_lifts(mesh_);
    std::map<std::int32_t, std::uint32_t> numbers;
    std::vector<Vec3> points;
    std::vector<std::uint32_t> indices;
    for (const std::int32_t h : options_.crack_edges) {
      const Triangle& t = mesh_.triangles[h / 3];
      for (const std::int32_t v : {t[h % 3], t[(h + 1) % 3]}) {
        const auto [found, is_new] =
            numbers.try_emplace(v, static_cast<std::uint32_t>(points.size()));
        if (is_new) points.push_back(mesh_.positions[v] + lifts[v]);
        indices.push_back(found->second);
      }
    }
    const std::size_t place = output_.add(floats(points, 3), SceneOutput::Use::vertices, &bounded);
    Json primitive{{"mode", lines_mode},
                   {"attributes", {{"POSITION", place}}},
                   {"indices", output_.add_indices(indices, points.size(), 0)},
                   {"material", add_line_material(output_)}};
    Json& meshes = output_.root["meshes"];
    add_top_node({{"name", "crack_lines"}, {"mesh", meshes.size()}});
    meshes.push_back(
        {{"name", "crack_lines"}, {"primitives", Json::array({std::move(primitive)})}});
  }

  const SurfaceMesh& mesh_;
  const GltfDocument& document_;
  const MeshFileOptions& options_;
  SceneOutput output_;
  std::string name_ = "the scene";
  GltfNodes nodes_;
  std::optional<std::size_t> wall_;
  std::vector<std::size_t> moving_;  // nodes that show the surface
};

}  // namespace

std::string format_resurfaced(const SurfaceMesh& mesh, const GltfDocument& document,
                              const MeshFileOptions& options, const Context& context) {
  return Resurfacer(mesh, document, options).write(context);
}

}  // namespace craze
