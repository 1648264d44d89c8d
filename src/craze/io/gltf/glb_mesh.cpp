// Format: Khronos Group, "glTF 2.0 Specification", 2021, section 3.7.
#include "craze/io/gltf/glb_mesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "craze/base/progress_meter.h"
#include "craze/io/gltf/gltf_primitive.h"
#include "craze/io/gltf/line_lifts.h"
#include "craze/io/polygons/single_precision.h"

namespace craze {

namespace {

using nlohmann::ordered_json;

float to_float(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -most, most));
}

class MeshWriter {
 public:
  MeshWriter(const SurfaceMesh& mesh, UnifiedCorners unified, GlbBuffer& buffer,
             const Context& context)
      : mesh_(mesh),
        unified_(std::move(unified)),
        buffer_(buffer),
        meter_(context, "write", 3 + mesh.vertex_attributes.size(), 1) {}

  ordered_json write(const Vec3& origin, const std::vector<MorphStage>& stages,
                     GlbMaterials& materials) {
    write_positions(origin);
    write_corner_values();
    for (const Attribute& a : mesh_.vertex_attributes) write_attribute(a);
    const ordered_json targets = write_targets(stages);
    ordered_json json;
    json["primitives"] = write_primitives(targets, materials);
    if (stages.empty()) return json;
    json["weights"] = std::vector<int>(stages.size(), 0);
    for (std::size_t k = 0; k < stages.size(); ++k) {
      json["extras"]["targetNames"].push_back("before_" + std::to_string(k + 1));
    }
    return json;
  }

 private:
  void next_step() { meter_.at(steps_++); }

  void write_positions(const Vec3& origin) {
    next_step();
    std::vector<std::array<float, 3>> positions;
    positions.reserve(unified_.sources.size());
    for (const std::int32_t v : unified_.sources) {
      positions.push_back(to_floats(mesh_.positions[v] - origin, "GLB"));
    }
    attributes_["POSITION"] = buffer_.add_positions(positions);
  }

  void add(const std::string& name, const std::vector<float>& numbers, int components) {
    attributes_[name] = buffer_.add_floats(numbers, components, GlbBuffer::Target::vertices);
  }

  void write_corner_values() {
    next_step();
    std::vector<float> numbers;
    numbers.reserve(3 * unified_.normals.size());
    for (const Vec3& n : unified_.normals) {
      for (int k = 0; k < 3; ++k) numbers.push_back(to_float(n[k]));
    }
    if (!numbers.empty()) add("NORMAL", numbers, 3);
    numbers.clear();
    for (const Vec2& uv : unified_.uvs) {
      numbers.push_back(to_float(uv.x()));
      numbers.push_back(to_float(1 - uv.y()));
    }
    if (!numbers.empty()) add("TEXCOORD_0", numbers, 2);
    if (mesh_.vertex_colors.empty()) return;
    numbers.clear();
    for (const std::int32_t v : unified_.sources) {
      for (const float c : mesh_.vertex_colors[v]) numbers.push_back(std::clamp(c, 0.0f, 1.0f));
    }
    add("COLOR_0", numbers, 4);
  }

  void write_attribute(const Attribute& a) {
    next_step();
    for (auto& [name, first, n] : glb_columns(a)) {
      while (attributes_.contains(name)) name += '_';
      std::vector<float> numbers;
      numbers.reserve(static_cast<std::size_t>(n) * unified_.sources.size());
      for (const std::int32_t v : unified_.sources) {
        const double* values = &a.values[static_cast<std::size_t>(a.components) * v + first];
        for (int k = 0; k < n; ++k) numbers.push_back(to_float(values[k]));
      }
      add(name, numbers, n);
    }
  }

  ordered_json write_targets(const std::vector<MorphStage>& stages) {
    ordered_json targets = ordered_json::array();
    if (stages.empty()) return targets;
    std::vector<std::vector<std::uint32_t>> copies(mesh_.positions.size());
    for (std::size_t i = 0; i < unified_.sources.size(); ++i) {
      copies[unified_.sources[i]].push_back(static_cast<std::uint32_t>(i));
    }
    for (const MorphStage& stage : stages) {
      std::vector<std::pair<std::uint32_t, std::array<float, 3>>> moved;
      for (std::size_t i = 0; i < stage.vertices.size(); ++i) {
        const auto back = to_floats(-stage.shifts[i], "GLB");
        for (const std::uint32_t copy : copies[stage.vertices[i]]) moved.emplace_back(copy, back);
      }
      std::sort(moved.begin(), moved.end());
      std::vector<std::uint32_t> indices;
      std::vector<std::array<float, 3>> shifts;
      for (const auto& [index, shift] : moved) {
        indices.push_back(index);
        shifts.push_back(shift);
      }
      targets.push_back(
          {{"POSITION", buffer_.add_sparse_vectors(unified_.sources.size(), indices, shifts)}});
    }
    return targets;
  }

  ordered_json write_primitives(const ordered_json& targets, GlbMaterials& materials) {
    next_step();
    std::map<std::int32_t, std::vector<std::uint32_t>> corners;  // −1, no material, comes first
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      auto& of = corners[mesh_.face_materials.empty() ? -1 : mesh_.face_materials[f]];
      for (const std::int32_t v : unified_.triangles[f]) {
        of.push_back(static_cast<std::uint32_t>(v));
      }
    }
    ordered_json primitives = ordered_json::array();
    for (const auto& [material, indices] : corners) {
      primitives.push_back({{"attributes", attributes_},
                            {"indices", buffer_.add_indices(indices)},
                            {"material", materials.number(mesh_, material)}});
      if (!targets.empty()) primitives.back()["targets"] = targets;
    }
    return primitives;
  }

  const SurfaceMesh& mesh_;
  UnifiedCorners unified_;
  GlbBuffer& buffer_;
  ProgressMeter meter_;
  std::size_t steps_ = 0;
  ordered_json attributes_ = ordered_json::object();
};

}  // namespace

std::vector<GlbColumns> glb_columns(const Attribute& a) {
  if (a.components <= 4) return {{glb_attribute_name(a.name), 0, a.components}};
  std::vector<GlbColumns> columns;
  for (int i = 0; i < a.components; ++i) {
    columns.push_back({glb_attribute_name(a.name + "_" + std::to_string(i)), i, 1});
  }
  return columns;
}

std::string glb_attribute_name(const std::string& name) {
  std::string result = "_";
  for (const char c : name) {
    const bool is_lower = c >= 'a' && c <= 'z';
    const bool is_kept = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    result += is_lower ? static_cast<char>(c - 'a' + 'A') : is_kept ? c : '_';
  }
  return result;
}

std::size_t GlbMaterials::number(const SurfaceMesh& mesh, std::int32_t face_material) {
  for (const auto& [material, number] : known_) {
    if (material == face_material) return number;
  }
  known_.emplace_back(face_material, json_.size());
  const auto own = static_cast<std::size_t>(face_material);
  if (face_material >= 0 && own < library_.materials.size() && !library_.materials[own].is_null()) {
    json_.push_back(library_.materials[own]);
    return json_.size() - 1;
  }
  const std::string name = face_material < 0 ? "surface" : mesh.material_names[face_material];
  // Colours of vertices are multiplied by the material's.
  const double grey = name == "crack_wall" ? 0.25 : mesh.vertex_colors.empty() ? 0.8 : 1.0;
  json_.push_back({{"name", name},
                   {"pbrMetallicRoughness",
                    {{"baseColorFactor", {grey, grey, grey, 1.0}},
                     {"metallicFactor", 0.0},
                     {"roughnessFactor", 0.8}}},
                   {"doubleSided", true}});
  return json_.size() - 1;
}

std::size_t GlbMaterials::add_line() {
  json_.push_back({{"name", "crack_line"},
                   {"pbrMetallicRoughness",
                    {{"baseColorFactor", {0.02, 0.02, 0.02, 1.0}},
                     {"metallicFactor", 0.0},
                     {"roughnessFactor", 0.8}}},
                   {"extensions", {{"KHR_materials_unlit", ordered_json::object()}}}});
  return json_.size() - 1;
}

ordered_json glb_lines(const SurfaceMesh& mesh, const Vec3& origin,
                       const std::vector<std::int32_t>& halfedges, GlbBuffer& buffer,
                       GlbMaterials& materials) {
  const std::vector<Vec3> lifts = line_lifts(mesh);
  std::map<std::int32_t, std::uint32_t> numbers;
  std::vector<std::array<float, 3>> points;
  std::vector<std::uint32_t> indices;
  for (const std::int32_t h : halfedges) {
    const Triangle& t = mesh.triangles[h / 3];
    for (const std::int32_t v : {t[h % 3], t[(h + 1) % 3]}) {
      const auto [found, is_new] =
          numbers.try_emplace(v, static_cast<std::uint32_t>(points.size()));
      if (is_new) points.push_back(to_floats(mesh.positions[v] + lifts[v] - origin, "GLB"));
      indices.push_back(found->second);
    }
  }
  ordered_json primitive{{"mode", lines_mode},
                         {"attributes", {{"POSITION", buffer.add_positions(points)}}},
                         {"indices", buffer.add_indices(indices)},
                         {"material", materials.add_line()}};
  return {{"name", "crack_lines"}, {"primitives", ordered_json::array({std::move(primitive)})}};
}

ordered_json glb_mesh(const SurfaceMesh& mesh, UnifiedCorners unified, const Vec3& origin,
                      const std::vector<MorphStage>& stages, GlbBuffer& buffer,
                      GlbMaterials& materials, const Context& context) {
  return MeshWriter(mesh, std::move(unified), buffer, context).write(origin, stages, materials);
}

}  // namespace craze
