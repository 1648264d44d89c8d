#include "craze/io/gltf/scene/scene_writer.h"

#include <algorithm>
#include <map>
#include <optional>

#include "craze/base/progress_meter.h"
#include "craze/error.h"
#include "craze/io/gltf/gltf_primitive.h"
#include "craze/io/gltf/gltf_skin.h"
#include "craze/io/gltf/line_lifts.h"
#include "craze/io/gltf/scene/crack_primitives.h"
#include "craze/io/gltf/scene/fragment_nodes.h"
#include "craze/io/gltf/scene/primitive_vertices.h"
#include "craze/io/gltf/scene/scene_growth.h"
#include "craze/io/gltf/scene/scene_materials.h"
#include "craze/io/gltf/scene/showings.h"
#include "craze/mesh/mesh_parts.h"

namespace craze {

namespace {

constexpr std::size_t unsigned_byte = 5121;

class SceneWriter {
 public:
  SceneWriter(const SurfaceMesh& mesh, const GltfDocument& document, const MeshFileOptions& options,
              const Context& context)
      : document_(document),
        options_(options),
        context_(context),
        cut_(document, mesh, *options.origin, options.crack_edges, !options.objects.empty()),
        output_(document),
        name_("the scene"),
        accessors_(document.root(), document.bin(), no_files_, document.bin().size() + most_zeros,
                   name_),
        nodes_(document.root(), name_) {}

  std::string write() {
    const std::vector<Showing> showings = separate_showings(cut_, accessors_, output_);
    std::optional<SceneGrowth> growth;
    if (options_.animation) growth.emplace(*options_.animation);
    ProgressMeter meter(context_, "write", showings.size(), 1);
    for (std::size_t i = 0; i < showings.size(); ++i) {
      meter.at(i);
      if (options_.objects.empty()) {
        write_showing(showings[i], growth ? &*growth : nullptr);
      } else {
        write_apart(showings[i], growth ? &*growth : nullptr);
      }
    }
    if (growth) growth->finish(accessors_, output_);
    return output_.pack();
  }

 private:
  /// Parts that share all attributes share vertices.
  void write_showing(const Showing& showing, SceneGrowth* growth) {
    std::map<std::int32_t, std::vector<std::size_t>> groups;
    for (const std::size_t p : showing.parts) {
      if (cut_.parts()[p].is_changed) groups[document_.parts()[p].first_vertex].push_back(p);
    }
    if (growth) growth->begin(showing, output_);
    std::vector<Json> walls;
    Json lines = Json::array();
    for (const auto& [first, parts] : groups) {
      const GltfPart& part = document_.parts()[parts[0]];
      const std::vector<double> weights = weights_of(part);
      const PrimitivePlace place{part, joints_of(part), weights};
      const PrimitiveSource source{cut_, primitive_of(part), place, accessors_};
      write_group(parts, source.primitive, place, showing.mesh, growth);
      std::vector<std::int32_t> edges;
      for (const std::size_t p : parts) {
        const PartFaces& own = cut_.parts()[p];
        edges.insert(edges.end(), own.crack_edges.begin(), own.crack_edges.end());
        if (own.walls.empty()) continue;
        walls.push_back(wall_primitive(source, own.walls, wall_material(), growth, output_));
      }
      if (edges.empty()) continue;
      if (!line_style_)
        line_style_ = LineStyle{line_lifts(cut_.mesh()), add_line_material(output_)};
      lines.push_back(line_primitive(source, edges, *line_style_, output_));
    }
    for (Json& wall : walls) {
      output_.root["meshes"][showing.mesh]["primitives"].push_back(std::move(wall));
    }
    if (growth) growth->end(output_);
    if (!lines.empty()) add_line_node(showing, std::move(lines), output_);
  }

  /// As fragments.
  void write_apart(const Showing& showing, SceneGrowth* growth) {
    const Attribute& numbers = part_numbers(cut_.mesh(), options_.objects);
    std::vector<LoosePart> loose;
    std::vector<std::size_t> taken;
    bool is_skinned = true;
    for (const std::size_t p : showing.parts) {
      const GltfPart& part = document_.parts()[p];
      const PartFaces& own = cut_.parts()[p];
      if (own.faces.empty()) continue;
      taken.push_back(part.primitive);
      is_skinned = is_skinned && part.skin;
      const std::vector<double> weights = weights_of(part);
      const PrimitiveSource source{
          cut_, primitive_of(part), {part, joints_of(part), weights}, accessors_};
      const auto add = [&](const std::vector<std::int32_t>& faces, LoosePrimitive::Kind kind) {
        if (faces.empty()) return;
        loose.push_back({{source, faces, kind, options_.bent}, {}, {}});
        for (const std::int32_t f : faces) loose.back().fragment.push_back(numbers.values[f]);
      };
      add(own.faces, LoosePrimitive::Kind::faces);
      add(own.walls, LoosePrimitive::Kind::walls);
      if (!own.walls.empty()) loose.back().material = wall_material();
    }
    add_fragment_nodes(showing, loose, taken, options_.objects, is_skinned, options_.solids, growth,
                       output_);
  }

  std::size_t wall_material() {
    if (!wall_material_) wall_material_ = add_wall_material(output_);
    return *wall_material_;
  }

  /// The cut primitives that share these vertices.
  void write_group(const std::vector<std::size_t>& parts, const Json& primitive,
                   const PrimitivePlace& place, std::size_t mesh, SceneGrowth* growth) {
    PrimitiveVertices vertices(primitive, place, accessors_,
                               [](const std::string&) { return true; });
    CutVertices numbers(vertices.count());
    std::vector<std::vector<std::uint32_t>> indices;
    std::map<std::uint32_t, Vec3> normals;
    for (const std::size_t p : parts) indices.push_back(indices_of(p, numbers, normals));
    vertices.append(cut_, numbers.added());
    vertices.move(cut_, numbers.owner());
    if (options_.bent && vertices.has_normals()) {
      for (const auto& [v, normal] : normals) vertices.turn_normal(v, normal);
    }
    std::vector<std::int32_t> owner = numbers.owner();
    for (const CutVertices::Vertex& added : numbers.added()) owner.push_back(added.of);
    add_crack_attributes(cut_, owner, vertices);
    if (growth) growth->add_targets(vertices, owner);
    const Json attributes = vertices.write_attributes(output_);
    const Json targets = vertices.write_targets(output_);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const GltfPart& part = document_.parts()[parts[k]];
      Json& made = output_.root["meshes"][mesh]["primitives"][part.primitive];
      made["attributes"] = attributes;
      if (!targets.empty()) made["targets"] = targets;
      made["indices"] = output_.add_indices(indices[k], vertices.count(), index_type(part));
      forget_form(made);
    }
  }

  /// The triangles of the cut mesh, and those of the document that it left out, in the document's
  /// order. `normals` gets those that the cut mesh has at each vertex.
  std::vector<std::uint32_t> indices_of(std::size_t p, CutVertices& numbers,
                                        std::map<std::uint32_t, Vec3>& normals) const {
    const std::vector<Vec3>& corner_normals = cut_.mesh().corner_normals;
    const GltfPart& part = document_.parts()[p];
    const std::vector<std::int32_t>& faces = cut_.parts()[p].faces;
    std::vector<std::uint32_t> indices;
    auto next = faces.begin();
    for (std::int32_t t = part.first_face; t < part.end_face; ++t) {
      if (next == faces.end() || cut_.source(*next) != t) {
        const auto old = cut_.triangle(part, t);
        indices.insert(indices.end(), old.begin(), old.end());
      }
      for (; next != faces.end() && cut_.source(*next) == t; ++next) {
        for (const int i : cut_.order(part, *next)) {
          const std::int32_t v = cut_.mesh().triangles[*next][static_cast<std::size_t>(i)];
          indices.push_back(numbers.number(cut_.blend(part, *next, i), v));
          if (!options_.bent || corner_normals.empty()) continue;
          normals.emplace(
              indices.back(),
              corner_normals[3 * static_cast<std::size_t>(*next) + static_cast<std::size_t>(i)]);
        }
      }
    }
    return indices;
  }

  const Json& primitive_of(const GltfPart& part) const {
    return document_.root()["meshes"][part.mesh]["primitives"][part.primitive];
  }

  std::size_t index_type(const GltfPart& part) const {
    const auto indices = primitive_of(part).find("indices");
    if (indices == primitive_of(part).end()) return unsigned_byte;
    return document_.root()["accessors"][indices->get<std::size_t>()]["componentType"];
  }

  std::vector<double> weights_of(const GltfPart& part) const {
    return morph_weights(document_.root()["meshes"][part.mesh],
                         &document_.root()["nodes"][part.node], GltfJson(name_));
  }

  const std::vector<Eigen::Matrix4d>& joints_of(const GltfPart& part) {
    if (!part.skin) return no_joints_;
    auto found = joints_.find(*part.skin);
    if (found == joints_.end()) {
      found = joints_
                  .emplace(*part.skin,
                           joint_matrices(document_.root(), *part.skin, nodes_, accessors_, name_))
                  .first;
    }
    return found->second;
  }

  /// Of accessors without data, beyond what the buffer has.
  static constexpr std::size_t most_zeros = 4'000'000;

  const GltfDocument& document_;
  const MeshFileOptions& options_;
  const Context& context_;
  CutScene cut_;
  SceneOutput output_;
  std::string name_;
  FileLoader no_files_;
  GltfAccessors accessors_;
  GltfNodes nodes_;
  std::map<std::size_t, std::vector<Eigen::Matrix4d>> joints_;  // by skin
  const std::vector<Eigen::Matrix4d> no_joints_;
  std::optional<std::size_t> wall_material_;
  std::optional<LineStyle> line_style_;
};

}  // namespace

std::string format_scene(const SurfaceMesh& mesh, const GltfDocument& document,
                         const MeshFileOptions& options, const Context& context) {
  try {
    return SceneWriter(mesh, document, options, context).write();
  } catch (const Json::exception& error) {
    throw Error(ErrorKind::request, "cannot write the scene again", "GLB",
                std::string("something in it is not as glTF wants it; with "
                            "mesh.output = \"simulation\" its surface alone is written (") +
                    error.what() + ")");
  }
}

}  // namespace craze
