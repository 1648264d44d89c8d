// Format: Khronos Group, "glTF 2.0 Specification", 2021.
#include "craze/io/gltf/gltf.h"
#include "craze/mesh/morph_animation.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "craze/base/progress_meter.h"
#include "craze/io/gltf/glb_buffer.h"
#include "craze/io/gltf/glb_mesh.h"
#include "craze/io/gltf/growth_clip.h"
#include "craze/io/gltf/scene/resurfaced_scene.h"
#include "craze/io/gltf/scene/scene_writer.h"
#include "craze/io/gltf/solids/solid_node.h"
#include "craze/io/polygons/float_grid.h"
#include "craze/io/polygons/polygon_soup.h"
#include "craze/io/polygons/unify_corners.h"
#include "craze/mesh/mesh_parts.h"

namespace craze {

namespace {

using nlohmann::ordered_json;

ordered_json to_json(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

/// The hull of a solid, and the node that shows the solid.
struct SolidCollider {
  std::size_t of;
  std::string name;
  SurfaceMesh hull;
};

class GlbWriter {
 public:
  GlbWriter(const SurfaceMesh& mesh, const MeshFileOptions& options, const Context& context)
      : options_(options),
        context_(context),
        triangles_(std::max(1.0, static_cast<double>(mesh.triangles.size()))),
        library_(material_library(options.scene.get(), mesh)),
        materials_(library_) {}

  /// `normals`: unit, 3 #F, in place of the mesh's, or empty.
  void write(const SurfaceMesh& mesh, std::vector<Vec3> normals, ByteSink& sink) {
    const Vec3 far = far_origin(mesh);
    if (options_.objects.empty() && mesh.face_objects.empty()) {
      ordered_json node{{"mesh", 0}};
      if (!far.isZero(0)) node["translation"] = to_json(far);
      UnifiedCorners unified = unify_corners(mesh, normals);
      normals = std::vector<Vec3>();
      add_node(std::move(node), mesh, std::move(unified), far,
               options_.animation ? options_.animation->stages : std::vector<MorphStage>{});
    } else {
      SurfaceMesh whole = mesh;
      whole.corner_normals = std::move(normals);
      if (options_.objects.empty()) {
        add_objects(whole, far);
      } else {
        for (Vec3& p : whole.positions) p -= far;
        add_parts(whole);
      }
    }
    if (!options_.crack_edges.empty()) add_lines(mesh, far);
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
    add_colliders(root);
    root["meshes"] = meshes_;
    root["materials"] = materials_.json();
    add_pictures(root);
    const std::vector<std::string> extensions = extensions_of(root);
    if (!extensions.empty()) root["extensionsUsed"] = extensions;
    if (options_.animation) root["animations"] = ordered_json::array({animation()});
    buffer_.write(std::move(root), sink);
  }

 private:
  void add_node(ordered_json node, const SurfaceMesh& mesh, UnifiedCorners unified,
                const Vec3& origin, const std::vector<MorphStage>& stages) {
    if (context_.is_cancelled()) throw Cancelled();
    nodes_.push_back(std::move(node));
    const auto part = static_cast<double>(mesh.triangles.size()) / triangles_;
    meshes_.push_back(glb_mesh(mesh, std::move(unified), origin, stages, buffer_, materials_,
                               phase_part(context_, "write", written_, written_ + part)));
    written_ += part;
  }

  void add_parts(const SurfaceMesh& mesh) {
    const double grid = float_grid(mesh);
    for (const MeshPart& part : mesh_parts(mesh, options_.objects)) {
      ExtractedPart own = extract_part(mesh, part.faces);
      const Vec3 middle = options_.solids ? solid_mass(own.mesh).centre : centroid(own.mesh);
      const Vec3 origin = on_grid(middle, grid);
      for (Vec3& p : own.mesh.positions) p = on_grid(p, grid);
      ordered_json node{
          {"name", part.name}, {"mesh", meshes_.size()}, {"translation", to_json(origin)}};
      if (options_.solids) describe_solid(own.mesh, origin, part.name, node);
      add_node(std::move(node), own.mesh, unify_corners(own.mesh), origin,
               options_.animation ? stages_of(*options_.animation, own.vertices)
                                  : std::vector<MorphStage>{});
    }
  }

  void describe_solid(const SurfaceMesh& solid, const Vec3& origin, const std::string& name,
                      ordered_json& node) {
    SurfaceMesh placed;
    placed.triangles = solid.triangles;
    for (const Vec3& p : solid.positions) placed.positions.push_back(p - origin);
    node["extras"] = solid_extras(placed, *options_.solids);
    const std::string collider = collider_name(name, *options_.solids);
    if (!collider.empty()) colliders_.push_back({nodes_.size(), collider, hull_mesh(placed)});
  }

  /// Each below the node of its solid.
  void add_colliders(ordered_json& root) {
    Context silent = context_;
    silent.progress = nullptr;
    for (const SolidCollider& collider : colliders_) {
      if (collider.hull.triangles.empty()) continue;
      root["nodes"][collider.of]["children"] = ordered_json::array({root["nodes"].size()});
      root["nodes"].push_back({{"name", collider.name}, {"mesh", meshes_.size()}});
      meshes_.push_back(glb_mesh(collider.hull, unify_corners(collider.hull), Vec3::Zero(), {},
                                 buffer_, materials_, silent));
      meshes_.back()["name"] = collider.name;
    }
  }

  /// The objects of the input, each a node; faces without are one more, without a name.
  void add_objects(const SurfaceMesh& mesh, const Vec3& far) {
    std::map<std::int32_t, std::vector<std::int32_t>> faces_of;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      faces_of[mesh.face_objects[f]].push_back(static_cast<std::int32_t>(f));
    }
    for (const auto& [object, faces] : faces_of) {
      const ExtractedPart own = extract_part(mesh, faces);
      ordered_json node = ordered_json::object();
      if (object >= 0) node["name"] = mesh.object_names[object];
      node["mesh"] = meshes_.size();
      if (!far.isZero(0)) node["translation"] = to_json(far);
      add_node(std::move(node), own.mesh, unify_corners(own.mesh), far,
               options_.animation ? stages_of(*options_.animation, own.vertices)
                                  : std::vector<MorphStage>{});
    }
  }

  /// What the input's materials refer to.
  void add_pictures(ordered_json& root) {
    for (std::size_t i = 0; i < library_.images.size(); ++i) {
      if (library_.image_bytes[i].empty()) continue;
      library_.images[i]["bufferView"] = buffer_.add_bytes(library_.image_bytes[i]);
    }
    if (!library_.textures.empty()) root["textures"] = library_.textures;
    if (!library_.samplers.empty()) root["samplers"] = library_.samplers;
    if (!library_.images.empty()) root["images"] = library_.images;
  }

  /// A node of its own; below that of the parts where there is one, as their origin is.
  void add_lines(const SurfaceMesh& mesh, const Vec3& far) {
    ordered_json node{{"name", "crack_lines"}, {"mesh", meshes_.size()}};
    if (options_.objects.empty() && !far.isZero(0)) node["translation"] = to_json(far);
    nodes_.push_back(std::move(node));
    meshes_.push_back(glb_lines(mesh, far, options_.crack_edges, buffer_, materials_));
  }

  ordered_json animation() {
    const GrowthClipKeys clip = growth_clip_keys(*options_.animation);
    ordered_json json{{"name", "growth"}, {"channels", ordered_json::array()}};
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      json["channels"].push_back(
          {{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}});
    }
    const std::size_t input = buffer_.add_keys(clip.seconds);
    json["samplers"] = {{{"input", input},
                         {"interpolation", "LINEAR"},
                         {"output", buffer_.add_floats(clip.weights, 1, GlbBuffer::Target::none)}}};
    return json;
  }

  const MeshFileOptions& options_;
  const Context& context_;
  const double triangles_;
  double written_ = 0;  // share of them
  GlbBuffer buffer_;
  MaterialLibrary library_;
  GlbMaterials materials_;
  ordered_json nodes_ = ordered_json::array(), meshes_ = ordered_json::array();
  std::vector<SolidCollider> colliders_;
};

}  // namespace

bool keeps_scene(const MeshFileOptions& options) {
  const bool is_gltf = dynamic_cast<const GltfDocument*>(options.scene.get()) != nullptr;
  return is_gltf && options.origin;
}

bool keeps_nodes(const SurfaceMesh& mesh, const MeshFileOptions& options) {
  const auto* document = dynamic_cast<const GltfDocument*>(options.scene.get());
  return document && !mesh.face_objects.empty();
}

void write_glb(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
               const Context& context) {
  if (options.normals && (keeps_scene(options) || keeps_nodes(mesh, options))) {
    SurfaceMesh shaded = mesh;
    shaded.corner_normals = options.normals();
    MeshFileOptions own = options;
    own.normals = {};
    write_glb(shaded, own, sink, context);
    return;
  }
  if (keeps_scene(options)) {
    const auto& document = dynamic_cast<const GltfDocument&>(*options.scene);
    sink.put(format_scene(mesh, document, options, context));
    return;
  }
  if (keeps_nodes(mesh, options)) {
    const auto& document = dynamic_cast<const GltfDocument&>(*options.scene);
    sink.put(format_resurfaced(mesh, document, options, context));
    return;
  }
  std::vector<Vec3> normals = options.normals ? options.normals() : mesh.corner_normals;
  normalize_corner_normals(mesh, normals);
  GlbWriter(mesh, options, context).write(mesh, std::move(normals), sink);
}

}  // namespace craze
