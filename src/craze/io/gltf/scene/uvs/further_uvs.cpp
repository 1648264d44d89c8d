// Format: Khronos Group, "glTF 2.0 Specification", 2021, section 3.7.2.
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <string>
#include <tuple>

#include "craze/io/gltf/scene/crack_primitives.h"
#include "craze/io/gltf/scene/cut_scene.h"
#include "craze/io/gltf/scene/primitive_vertices.h"
#include "craze/io/gltf/scene/showings.h"
#include "craze/io/gltf/scene/uvs/uv_sets.h"
#include "craze/mesh/corner_frames.h"

namespace craze {

namespace {

constexpr std::size_t unsigned_byte = 5121;

/// The faces of the materials, as they are.
struct Chosen {
  SurfaceMesh mesh;
  SurfaceOrigin origin;
};

Chosen chosen_faces(const GltfDocument& document, const std::set<std::int32_t>& materials) {
  Chosen chosen;
  chosen.mesh.positions = document.positions();
  for (const GltfPart& part : document.parts()) {
    if (materials.count(material_of(document, part)) == 0) continue;
    for (std::int32_t f = part.first_face; f < part.end_face; ++f) {
      chosen.mesh.triangles.push_back(document.triangles()[f]);
      chosen.origin.face.push_back(f);
      for (int i = 0; i < 3; ++i) chosen.origin.weights.push_back(Vec3::Unit(i));
    }
  }
  chosen.origin.wall_begin = static_cast<std::int32_t>(chosen.origin.face.size());
  return chosen;
}

class UvWriter {
 public:
  UvWriter(const GltfDocument& document, const FurtherUvs& uvs)
      : document_(document),
        uvs_(uvs),
        chosen_(chosen_faces(document, uvs.materials)),
        cut_(document, chosen_.mesh, chosen_.origin, no_edges_, true),
        output_(document),
        accessors_(document.root(), document.bin(), no_files_, document.bin().size() + most_zeros,
                   document_name),
        parts_(document.parts()) {
    surface_.positions = document.positions();
    surface_.triangles = document.triangles();
    for (const std::string& name : document.attributes()) {
      surface_.vertex_attributes.push_back({name, 1, {}});
    }
  }

  std::shared_ptr<const GltfDocument> write() {
    for (const Showing& showing : separate_showings(cut_, accessors_, output_)) {
      std::map<std::int32_t, std::vector<std::size_t>> groups;  // that share vertices
      for (const std::size_t p : showing.parts) {
        GltfPart& part = parts_[p];
        if (part.node != showing.node) part.copy.reset();
        part.node = showing.node;
        part.mesh = showing.mesh;
        if (cut_.parts()[p].is_changed) groups[part.first_vertex].push_back(p);
      }
      for (const auto& [first, group] : groups) write_group(group);
    }
    set_others_apart();
    SceneOutput::Parts made = output_.finish();
    return std::make_shared<const GltfDocument>(std::move(made.root), std::move(made.bin),
                                                std::move(parts_), surface_);
  }

 private:
  void write_group(const std::vector<std::size_t>& group) {
    const GltfPart old = document_.parts()[group[0]];
    const Json& primitive = document_.root()["meshes"][old.mesh]["primitives"][old.primitive];
    const PrimitivePlace place{old, no_joints_, no_weights_};
    const PrimitiveVertices all(primitive, place, accessors_,
                                [](const std::string& name) { return name != "TANGENT"; });
    std::vector<std::size_t> from(all.count());
    std::iota(from.begin(), from.end(), std::size_t{0});
    std::vector<char> is_taken(all.count(), 0);
    GltfElements set;
    set.components = 2;
    set.bytes.assign(all.count() * set.size(), '\0');
    set.count = all.count();
    std::map<std::tuple<std::uint32_t, double, double>, std::uint32_t> numbers;
    const auto number = [&](std::uint32_t vertex, const Vec2& uv) {
      const auto [found, is_new] = numbers.try_emplace({vertex, uv.x(), uv.y()}, vertex);
      if (!is_new) return found->second;
      const std::array<double, 2> stored{uv.x(), 1 - uv.y()};
      if (!is_taken[vertex]) {
        is_taken[vertex] = 1;
        set.set(vertex, stored.data());
      } else {
        found->second = static_cast<std::uint32_t>(from.size());
        from.push_back(vertex);
        set.append(stored.data());
      }
      return found->second;
    };
    const auto first = static_cast<std::int32_t>(surface_.positions.size());
    std::vector<std::vector<std::uint32_t>> indices;
    for (const std::size_t p : group) {
      const GltfPart& part = document_.parts()[p];
      std::vector<std::uint32_t>& own = indices.emplace_back();
      for (std::int32_t f = part.first_face; f < part.end_face; ++f) {
        std::array<std::uint32_t, 3> t{};
        for (std::size_t i = 0; i < 3; ++i) {
          const auto corner = 3 * static_cast<std::size_t>(f) + i;
          const auto vertex =
              static_cast<std::uint32_t>(document_.triangles()[f][i] - part.first_vertex);
          t[i] = number(vertex, uvs_.corners[corner]);
          surface_.triangles[f][i] = first + static_cast<std::int32_t>(t[i]);
        }
        if (part.mirrored) std::swap(t[1], t[2]);
        own.insert(own.end(), t.begin(), t.end());
      }
    }
    for (const std::size_t v : from) {
      surface_.positions.push_back(
          document_.positions()[static_cast<std::size_t>(old.first_vertex) + v]);
    }
    PrimitiveVertices vertices(all, from);
    const std::string key = "TEXCOORD_" + std::to_string(uvs_.number);
    vertices.set(key, std::move(set));
    Json attributes = vertices.write_attributes(output_);
    // Sets are numbered without gaps.
    for (std::size_t n = 0; n < uvs_.number; ++n) {
      attributes.emplace("TEXCOORD_" + std::to_string(n), attributes[key]);
    }
    if (primitive["attributes"].contains("TANGENT") && vertices.has_normals()) {
      attributes["TANGENT"] =
          output_.add(tangents_of(vertices, group, indices), SceneOutput::Use::vertices);
    }
    const Json targets = vertices.write_targets(output_);
    for (std::size_t k = 0; k < group.size(); ++k) {
      GltfPart& part = parts_[group[k]];
      part.first_vertex = first;
      Json& made = output_.root["meshes"][part.mesh]["primitives"][part.primitive];
      made["attributes"] = attributes;
      if (!targets.empty()) made["targets"] = targets;
      made["indices"] = output_.add_indices(indices[k], vertices.count(), unsigned_byte);
      forget_form(made);
    }
  }

  /// Of the new set, in the axes that the file gives vertices in.
  GltfElements tangents_of(const PrimitiveVertices& vertices, const std::vector<std::size_t>& group,
                           const std::vector<std::vector<std::uint32_t>>& indices) const {
    SurfaceMesh local;
    for (std::size_t v = 0; v < vertices.count(); ++v) {
      local.positions.push_back(vertices.position(v));
    }
    for (std::size_t k = 0; k < group.size(); ++k) {
      const GltfPart& part = document_.parts()[group[k]];
      auto corner = 3 * static_cast<std::size_t>(part.first_face);
      for (std::size_t i = 0; i < indices[k].size(); i += 3, corner += 3) {
        Triangle t{};
        for (std::size_t j = 0; j < 3; ++j) {
          // As the file turns its triangles.
          const std::size_t own = part.mirrored && j > 0 ? 3 - j : j;
          t[j] = static_cast<std::int32_t>(indices[k][i + j]);
          local.corner_uvs.push_back(uvs_.corners[corner + own]);
          local.corner_normals.push_back(vertices.normal(indices[k][i + j]));
        }
        local.triangles.push_back(t);
      }
    }
    const CornerTangents made = corner_tangents(local, local.corner_normals);
    std::vector<std::array<double, 4>> of(vertices.count(), {1, 0, 0, 1});
    for (std::size_t f = 0; f < local.triangles.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& t = made.tangent[3 * f + i];
        of[local.triangles[f][i]] = {t.x(), t.y(), t.z(), static_cast<double>(made.handed[f])};
      }
    }
    GltfElements tangents;
    tangents.components = 4;
    for (const auto& t : of) tangents.append(t.data());
    return tangents;
  }

  /// What has one of the materials without the set goes on with the material as it was.
  void set_others_apart() {
    const std::string key = "TEXCOORD_" + std::to_string(uvs_.number);
    std::map<std::size_t, std::size_t> copies;
    for (Json& mesh : output_.root["meshes"]) {
      for (Json& primitive : mesh["primitives"]) {
        const auto material = primitive.find("material");
        if (material == primitive.end() || primitive["attributes"].contains(key)) continue;
        const auto own = material->get<std::size_t>();
        if (uvs_.materials.count(static_cast<std::int32_t>(own)) == 0) continue;
        Json& materials = output_.root["materials"];
        const auto [copy, is_new] = copies.try_emplace(own, materials.size());
        if (is_new) {
          Json same = materials[own];
          materials.push_back(std::move(same));
        }
        primitive["material"] = copy->second;
      }
    }
  }

  /// Of accessors without data, beyond what the buffer has.
  static constexpr std::size_t most_zeros = 4'000'000;

  const GltfDocument& document_;
  const FurtherUvs& uvs_;
  const std::vector<std::int32_t> no_edges_;
  Chosen chosen_;
  CutScene cut_;
  SceneOutput output_;
  FileLoader no_files_;
  GltfAccessors accessors_;
  const std::vector<Eigen::Matrix4d> no_joints_;
  const std::vector<double> no_weights_;
  std::vector<GltfPart> parts_;
  SurfaceMesh surface_;
};

}  // namespace

std::shared_ptr<const GltfDocument> with_further_uvs(const GltfDocument& document,
                                                     const FurtherUvs& uvs) {
  return UvWriter(document, uvs).write();
}

}  // namespace craze
