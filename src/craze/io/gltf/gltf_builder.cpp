// Format: Khronos Group, "glTF 2.0 Specification", 2021, section 3.7.
#include "craze/io/gltf/gltf_builder.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/polygons/polygon_soup.h"
#include "craze/mesh/bounding_diagonal.h"

namespace craze {

namespace {

constexpr std::size_t triangles_mode = 4, strip_mode = 5, fan_mode = 6;
constexpr Color white{1, 1, 1, 1};
/// Of a primitive's JSON, that cost as much as a vertex.
constexpr std::size_t characters_per_vertex = 64;
/// Stands for the mesh's size until that is known.
constexpr double far_away = std::numeric_limits<double>::infinity();

/// What an attribute is on primitives that lack it: as a run says that there is no crack, else 0.
double missing_value(const std::string& attribute) {
  if (attribute == "crack_distance") return far_away;
  return attribute == "crack_time" || attribute == "crack_growth" ? -1 : 0;
}

}  // namespace

void GltfBuilder::spend(std::size_t elements) {
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  spent_ += elements;
  if (spent_ > std::min(most, budget_ + 2 * accessors_.loaded_bytes())) {
    json_.fail("its instances expand to too many elements for its size; join them before");
  }
}

const std::vector<Eigen::Matrix4d>& GltfBuilder::joints_of(std::size_t skin) {
  const auto found = joints_.find(skin);
  if (found != joints_.end()) return found->second;
  return joints_.emplace(skin, joint_matrices(root_, skin, nodes_, accessors_, source_.name))
      .first->second;
}

void GltfBuilder::add(const GltfInstance& instance) {
  const Json& mesh = json_.item(root_, "meshes", instance.mesh);
  const std::vector<double> weights = morph_weights(mesh, instance.node, json_);
  object_ = object_of(instance);
  std::map<std::string, Placed> placed;
  const Json& primitives = json_.array(mesh, "primitives");
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    spend(primitive_cost);
    if (!primitives[p].is_object()) json_.fail("a primitive is not an object");
    const std::size_t first = mesh_.triangles.size();
    const Placed* used = add_primitive(primitives[p], instance, weights, placed);
    if (mesh_.triangles.size() > first) add_part(first, *used, p, instance);
  }
}

std::int32_t GltfBuilder::object_of(const GltfInstance& instance) {
  const std::size_t key = instance.node_index;
  const auto [found, is_new] =
      objects_.try_emplace(key, static_cast<std::int32_t>(mesh_.object_names.size()));
  if (is_new) {
    const Json& named = instance.node ? *instance.node : root_["meshes"][instance.mesh];
    const std::string name = json_.text(named, "name");
    const char* kind = instance.node ? "node" : "mesh";
    mesh_.object_names.push_back(name.empty() ? fmt::format("{}_{}", kind, key) : name);
  }
  return found->second;
}

void GltfBuilder::add_part(std::size_t first_face, const Placed& placed, std::size_t primitive,
                           const GltfInstance& instance) {
  GltfPart part;
  part.first_face = static_cast<std::int32_t>(first_face);
  part.end_face = static_cast<std::int32_t>(mesh_.triangles.size());
  part.first_vertex = static_cast<std::int32_t>(placed.first);
  part.node = instance.node_index;
  part.mesh = instance.mesh;
  part.primitive = primitive;
  part.object = object_;
  part.copy = instance.copy;
  if (placed.by_joints) part.skin = instance.skin;
  part.transform = instance.transform;
  part.mirrored = placed.mirrored;
  parts_.push_back(part);
}

const GltfBuilder::Placed* GltfBuilder::add_primitive(const Json& json,
                                                      const GltfInstance& instance,
                                                      const std::vector<double>& weights,
                                                      std::map<std::string, Placed>& placed) {
  const std::size_t mode = json_.index_or(json, "mode", triangles_mode);
  unknown_modes_ += mode > fan_mode;
  if (mode < triangles_mode || mode > fan_mode || draws_cracks(json)) return nullptr;
  GltfPrimitive primitive(
      json, weights, accessors_, [this](std::size_t numbers) { spend(numbers); }, source_.name);
  if (!primitive.has("POSITION")) return nullptr;
  spend(primitive.attributes().size());

  // Primitives that share all attributes share vertices.
  const std::string key = primitive.key();
  spend(key.size() / characters_per_vertex);
  auto known = placed.find(key);
  if (known == placed.end()) known = placed.emplace(key, add_vertices(primitive, instance)).first;

  const std::size_t count = primitive.vertex_count();
  std::vector<std::uint32_t> indices;
  if (const auto accessor = json_.index(json, "indices")) {
    spend(accessors_.count(*accessor));
    indices = accessors_.read_indices(*accessor);
    for (const std::uint32_t i : indices) {
      if (i >= count) json_.fail(fmt::format("an index asks for vertex {} of {}", i, count));
    }
  } else {
    spend(count);
    indices.resize(count);
    std::iota(indices.begin(), indices.end(), 0u);
  }
  std::int32_t material = -1;
  if (const auto m = json_.index(json, "material")) {
    json_.item(root_, "materials", *m);
    material = static_cast<std::int32_t>(*m);
  }
  add_triangles(indices, mode, known->second.first, known->second.mirrored, material);
  return &known->second;
}

void GltfBuilder::add_triangles(const std::vector<std::uint32_t>& indices, std::size_t mode,
                                std::size_t base, bool mirrored, std::int32_t material) {
  const std::size_t n = indices.size();
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto vertex = [&](std::size_t i) { return static_cast<std::int32_t>(base + indices[i]); };
    // Strips are joined by triangles that are none.
    const bool joins = mode == strip_mode && (indices[a] == indices[b] ||
                                              indices[b] == indices[c] || indices[a] == indices[c]);
    if (joins) return;
    if (mirrored) std::swap(b, c);
    mesh_.triangles.push_back({vertex(a), vertex(b), vertex(c)});
    mesh_.face_materials.push_back(material);
    mesh_.face_objects.push_back(object_);
  };
  if (mode == triangles_mode) {
    left_over_ += n % 3;
    for (std::size_t i = 0; i + 2 < n; i += 3) add(i, i + 1, i + 2);
  } else if (mode == strip_mode) {
    for (std::size_t i = 0; i + 2 < n; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2);
  } else {
    for (std::size_t i = 1; i + 1 < n; ++i) add(0, i, i + 1);
  }
}

GltfBuilder::Placed GltfBuilder::add_vertices(GltfPrimitive& primitive,
                                              const GltfInstance& instance) {
  Placed placed{mesh_.positions.size(), false, false};
  const std::size_t count = primitive.vertex_count();
  const Values positions = primitive.read("POSITION", 3, 3);
  Placement placement{instance.transform, std::nullopt};
  if (instance.skin && primitive.has("JOINTS_0") && primitive.has("WEIGHTS_0")) {
    spend(8 * count);
    placement.joints.emplace(primitive.attributes(), count, joints_of(*instance.skin), accessors_,
                             source_.name);
  }
  const auto is_mirror = [](const Eigen::Matrix4d& m) {
    return m.topLeftCorner<3, 3>().determinant() < 0;
  };
  std::size_t turned_over = 0;
  mesh_.positions.reserve(mesh_.positions.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p = Eigen::Map<const Vec3>(&positions.values[3 * i]);
    if (placement.joints) {
      const Eigen::Matrix4d matrix = placement.joints->matrix(i);
      mesh_.positions.push_back((matrix * p.homogeneous()).head<3>());
      turned_over += is_mirror(matrix);
    } else {
      mesh_.positions.push_back((placement.whole * p.homogeneous()).head<3>());
    }
    if (!mesh_.positions.back().allFinite()) json_.fail("a transformed vertex is not finite");
  }
  placed.by_joints = placement.joints.has_value();
  placed.mirrored = placement.joints ? 2 * turned_over > count : is_mirror(placement.whole);
  for (const auto& [key, accessor] : primitive.attributes().items()) {
    if (key == "NORMAL") {
      add_normals(primitive.read("NORMAL", 3, 3), placement, placed.first);
    } else if (key == "TEXCOORD_0") {
      const Values uvs = primitive.read("TEXCOORD_0", 2, 2);
      uvs_.resize(placed.first, Vec2::Zero());
      for (std::size_t i = 0; i < count; ++i) {
        uvs_.emplace_back(uvs.values[2 * i], 1 - uvs.values[2 * i + 1]);
      }
    } else if (key == "COLOR_0") {
      add_colors(primitive.read("COLOR_0", 3, 4), placed.first);
    } else if (key.starts_with('_')) {
      const std::size_t index = json_.as_index(accessor, "attributes");
      if (accessors_.count(index) != count) {
        json_.fail(fmt::format("the accessor of {} has the wrong count", printable(key)));
      }
      add_attribute(key, accessors_.read_mended(index, mended_number(key)), placed.first);
    } else if (key == "TANGENT" || key.starts_with("TEXCOORD_") || key.starts_with("COLOR_")) {
      // Only the scene keeps it.
      const std::size_t index = json_.as_index(accessor, "attributes");
      if (accessors_.count(index) == count) accessors_.read_mended(index, mended_number(key));
    }
    if (accessor.is_number() && accessors_.broken().count(accessor.get<std::size_t>()) > 0) {
      broken_keys_.insert(key);
    }
  }
  return placed;
}

void GltfBuilder::add_normals(const Values& normals, const Placement& placement, std::size_t base) {
  // Normals follow the cofactors: the inverse transposed, times the determinant.
  const auto cofactors_of = [](const Eigen::Matrix4d& matrix) {
    const Mat3 linear = matrix.topLeftCorner<3, 3>();
    Mat3 cofactors;
    cofactors << linear.col(1).cross(linear.col(2)), linear.col(2).cross(linear.col(0)),
        linear.col(0).cross(linear.col(1));
    return linear.determinant() < 0 ? Mat3(-cofactors) : cofactors;
  };
  Mat3 cofactors = cofactors_of(placement.whole);
  normals_.resize(base, Vec3::Zero());
  for (std::size_t i = 0; i < normals.count; ++i) {
    if (placement.joints) cofactors = cofactors_of(placement.joints->matrix(i));
    const Vec3 n = cofactors * Eigen::Map<const Vec3>(&normals.values[3 * i]);
    normals_.push_back(n.allFinite() ? n : Vec3(0, 0, 0));
  }
}

void GltfBuilder::add_colors(const Values& colors, std::size_t base) {
  mesh_.vertex_colors.resize(base, white);
  for (std::size_t i = 0; i < colors.count; ++i) {
    Color& color = mesh_.vertex_colors.emplace_back(white);
    for (std::size_t k = 0; k < colors.components; ++k) {
      const double value = colors.values[colors.components * i + k];
      color[k] = static_cast<float>(std::clamp(value, 0.0, 1.0));
    }
  }
}

void GltfBuilder::extend(Attribute& attribute, std::size_t vertices) {
  const std::size_t size = static_cast<std::size_t>(attribute.components) * vertices;
  if (size <= attribute.values.size()) return;
  spend(size - attribute.values.size());
  attribute.values.resize(size, missing_value(attribute.name));
}

void GltfBuilder::add_attribute(const std::string& key, const Values& values, std::size_t base) {
  std::string name = key.substr(1);
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  auto& all = mesh_.vertex_attributes;
  auto found = std::find_if(all.begin(), all.end(), [&](const auto& a) { return a.name == name; });
  if (found == all.end()) {
    found = all.insert(all.end(), {name, static_cast<int>(values.components), {}});
  }
  const auto n = static_cast<std::size_t>(found->components);
  extend(*found, base);
  if (n != values.components || found->values.size() != n * base) {
    json_.fail(fmt::format("attribute '{}' is given twice, or in two sizes", printable(key)));
  }
  spend(values.values.size());
  found->values.insert(found->values.end(), values.values.begin(), values.values.end());
}

void GltfBuilder::warn() const {
  std::string keys;
  for (const std::string& key : broken_keys_) keys += (keys.empty() ? "" : ", ") + printable(key);
  if (!keys.empty()) source_.warn("numbers that are not finite are mended in " + keys);
  if (left_over_ > 0) {
    source_.warn(
        fmt::format("{} vertices at the ends of lists of triangles make none", left_over_));
  }
  if (unknown_modes_ > 0) {
    source_.warn(fmt::format("{} primitives of an unknown mode are not read", unknown_modes_));
  }
}

SurfaceMesh GltfBuilder::finish() {
  check_size(mesh_, source_.name);
  warn();
  for (const Json& material : json_.array(root_, "materials")) {
    const std::string text = material.is_object() ? json_.text(material, "name") : std::string();
    mesh_.material_names.push_back(
        text.empty() ? fmt::format("material_{}", mesh_.material_names.size()) : text);
  }
  if (mesh_.material_names.empty()) mesh_.face_materials.clear();
  mesh_.source_faces.resize(mesh_.triangles.size());
  std::iota(mesh_.source_faces.begin(), mesh_.source_faces.end(), 0);

  // Where some primitives lack what others have, its default stands in.
  const std::size_t count = mesh_.positions.size();
  if (!mesh_.vertex_colors.empty()) mesh_.vertex_colors.resize(count, white);
  for (Attribute& a : mesh_.vertex_attributes) {
    extend(a, count);
    if (missing_value(a.name) != far_away) continue;
    std::replace(a.values.begin(), a.values.end(), far_away, bounding_diagonal(mesh_.positions));
  }
  if (!uvs_.empty()) uvs_.resize(count, Vec2::Zero());
  if (!normals_.empty()) normals_.resize(count, Vec3::Zero());
  for (const Triangle& t : mesh_.triangles) {
    for (const std::int32_t v : t) {
      if (!uvs_.empty()) mesh_.corner_uvs.push_back(uvs_[v]);
      if (!normals_.empty()) mesh_.corner_normals.push_back(normals_[v]);
    }
  }
  normalize_corner_normals(mesh_);
  return std::move(mesh_);
}

}  // namespace craze
