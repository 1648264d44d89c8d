// Format: Khronos Group, "glTF 2.0 Specification", 2021.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <numeric>

#include "craze/io/byte_order.h"
#include "craze/io/gltf.h"
#include "craze/io/gltf_accessor.h"
#include "craze/io/gltf_json.h"
#include "craze/io/input_error.h"
#include "craze/io/polygon_soup.h"

namespace craze {

namespace {

using Mat4 = Eigen::Matrix4d;

struct Chunks {
  std::string_view json, bin;
};

/// A GLB's two chunks; a text file is all JSON.
Chunks split_chunks(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with("glTF")) return {bytes, {}};
  if (bytes.size() < 20) fail_input(name, "it is too short for GLB");
  if (load<std::uint32_t>(bytes.data() + 4) != 2) fail_input(name, "it is not GLB version 2");
  Chunks chunks;
  std::size_t at = 12;
  while (bytes.size() - at >= 8) {
    const std::size_t size = load<std::uint32_t>(bytes.data() + at);
    const std::string_view type = bytes.substr(at + 4, 4);
    at += 8;
    if (size > bytes.size() - at) fail_input(name, "it ends within a chunk");
    if (type == "JSON" && chunks.json.empty()) chunks.json = bytes.substr(at, size);
    if (type == std::string_view("BIN\0", 4) && chunks.bin.empty()) {
      chunks.bin = bytes.substr(at, size);
    }
    at += size;
  }
  return chunks;
}

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const std::string& name, const GltfLoader& loader)
      : name_(name),
        json_(name),
        chunks_(split_chunks(bytes, name)),
        root_(parse_json(chunks_.json, name)),
        accessors_(root_, chunks_.bin, loader, name),
        budget_(4'000'000 + 2 * bytes.size()) {}

  SurfaceMesh read() {
    if (!root_.is_object()) json_.fail("its JSON is not an object");
    const auto asset = root_.find("asset");
    if (asset == root_.end() || !asset->is_object() ||
        !json_.text(*asset, "version").starts_with("2")) {
      json_.fail("it is not glTF version 2");
    }
    for (const Json& material : json_.array(root_, "materials")) {
      const std::string text = material.is_object() ? json_.text(material, "name") : "";
      const std::size_t number = mesh_.material_names.size();
      mesh_.material_names.push_back(text.empty() ? "material_" + std::to_string(number) : text);
    }
    visit_scene();
    mesh_.source_faces.resize(mesh_.triangles.size());
    std::iota(mesh_.source_faces.begin(), mesh_.source_faces.end(), 0);
    check_size(mesh_, name_);
    fill_gaps();
    normalize_corner_normals(mesh_);
    return std::move(mesh_);
  }

 private:
  struct Visit {
    std::size_t node;
    Mat4 parent;
  };

  void visit_scene() {
    std::vector<Visit> stack;
    for (const std::size_t node : root_nodes()) stack.push_back({node, Mat4::Identity()});
    std::reverse(stack.begin(), stack.end());
    std::vector<bool> seen(json_.array(root_, "nodes").size(), false);
    while (!stack.empty()) {
      const Visit visit = stack.back();
      stack.pop_back();
      const Json& node = json_.item(root_, "nodes", visit.node);
      if (seen[visit.node]) {
        json_.fail("node " + std::to_string(visit.node) + " is reached by two ways");
      }
      seen[visit.node] = true;
      const Mat4 world = visit.parent * local_transform(node);
      if (!world.allFinite()) {
        json_.fail("the transform of node " + std::to_string(visit.node) + " is not finite");
      }
      if (const auto mesh = json_.index(node, "mesh")) add_mesh(*mesh, world);
      const Json& children = json_.array(node, "children");
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        stack.push_back({json_.as_index(*child, "children"), world});
      }
    }
    if (root_.contains("nodes")) return;
    for (std::size_t m = 0; m < json_.array(root_, "meshes").size(); ++m) {
      add_mesh(m, Mat4::Identity());
    }
  }

  /// Of the default scene, or of the first; without scenes, all nodes that are nobody's child.
  std::vector<std::size_t> root_nodes() const {
    std::vector<std::size_t> nodes;
    if (!json_.array(root_, "scenes").empty()) {
      const Json& scene = json_.item(root_, "scenes", json_.index_or(root_, "scene", 0));
      for (const Json& node : json_.array(scene, "nodes")) {
        nodes.push_back(json_.as_index(node, "nodes"));
      }
      return nodes;
    }
    const std::size_t count = json_.array(root_, "nodes").size();
    std::vector<bool> is_child(count, false);
    for (std::size_t i = 0; i < count; ++i) {
      for (const Json& child : json_.array(json_.item(root_, "nodes", i), "children")) {
        const std::size_t c = json_.as_index(child, "children");
        if (c < count) is_child[c] = true;
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_child[i]) nodes.push_back(i);
    }
    return nodes;
  }

  Mat4 local_transform(const Json& node) const {
    Mat4 matrix = Mat4::Identity();
    if (json_.numbers(node, "matrix", matrix.data(), 16)) return matrix;  // both column-major
    Vec3 translation = Vec3::Zero(), scale = Vec3::Ones();
    Eigen::Vector4d rotation(0, 0, 0, 1);
    json_.numbers(node, "translation", translation.data(), 3);
    json_.numbers(node, "rotation", rotation.data(), 4);
    json_.numbers(node, "scale", scale.data(), 3);
    const Eigen::Quaterniond q(rotation.w(), rotation.x(), rotation.y(), rotation.z());
    matrix.topLeftCorner<3, 3>() = q.normalized().toRotationMatrix() * scale.asDiagonal();
    matrix.topRightCorner<3, 1>() = translation;
    return matrix;
  }

  void add_mesh(std::size_t index, const Mat4& world) {
    const Json& mesh = json_.item(root_, "meshes", index);
    // Primitives that share all attributes share vertices.
    std::map<std::string, std::int32_t> first_vertices;
    for (const Json& primitive : json_.array(mesh, "primitives")) {
      if (!primitive.is_object()) json_.fail("a primitive is not an object");
      const std::size_t mode = json_.index_or(primitive, "mode", 4);
      if (mode < 4 || mode > 6) continue;  // points and lines are no surface
      if (const auto extensions = primitive.find("extensions");
          extensions != primitive.end() && extensions->is_object()) {
        if (extensions->contains("KHR_draco_mesh_compression")) {
          json_.fail("it is compressed with Draco, which is not supported; export it without");
        }
      }
      add_primitive(primitive, mode, world, first_vertices);
    }
  }

  void spend(std::size_t elements) {
    if (elements > budget_) {
      json_.fail("its instances expand to too many elements for its size; join them before");
    }
    budget_ -= elements;
  }

  void add_primitive(const Json& primitive, std::size_t mode, const Mat4& world,
                     std::map<std::string, std::int32_t>& first_vertices) {
    const auto found = primitive.find("attributes");
    if (found == primitive.end() || !found->is_object())
      json_.fail("a primitive has no attributes");
    const Json& attributes = *found;
    const auto position = json_.index(attributes, "POSITION");
    if (!position) return;
    const std::size_t count = accessors_.count(*position);
    const auto [known, is_new] = first_vertices.try_emplace(
        attributes.dump(), static_cast<std::int32_t>(mesh_.positions.size()));
    if (is_new) {
      spend(count);
      add_vertices(attributes, *position, world);
    }
    const std::int32_t base = known->second;

    std::vector<std::uint32_t> indices;
    if (const auto accessor = json_.index(primitive, "indices")) {
      spend(accessors_.count(*accessor));
      indices = accessors_.read_indices(*accessor);
      for (const std::uint32_t i : indices) {
        if (i >= count) {
          json_.fail("an index asks for vertex " + std::to_string(i) + " of " +
                     std::to_string(count));
        }
      }
    } else {
      spend(count);
      indices.resize(count);
      std::iota(indices.begin(), indices.end(), 0u);
    }
    std::int32_t material = -1;
    if (const auto m = json_.index(primitive, "material")) {
      if (*m >= mesh_.material_names.size()) json_.fail("a primitive's material does not exist");
      material = static_cast<std::int32_t>(*m);
    }
    const bool mirrored = world.topLeftCorner<3, 3>().determinant() < 0;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      const auto vertex = [&](std::size_t i) {
        return base + static_cast<std::int32_t>(indices[i]);
      };
      if (mirrored) std::swap(b, c);
      mesh_.triangles.push_back({vertex(a), vertex(b), vertex(c)});
      mesh_.face_materials.push_back(material);
    };
    const std::size_t n = indices.size();
    if (mode == 4) {
      for (std::size_t i = 0; i + 2 < n; i += 3) add(i, i + 1, i + 2);
    } else if (mode == 5) {
      for (std::size_t i = 0; i + 2 < n; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2);
    } else {
      for (std::size_t i = 1; i + 1 < n; ++i) add(0, i, i + 1);
    }
  }

  /// The values of an attribute that must have one of two sizes for each of `count` vertices.
  GltfAccessors::Values read_attribute(const Json& attributes, const char* key, std::size_t count,
                                       std::size_t components, std::size_t or_components) {
    auto values = accessors_.read(*json_.index(attributes, key));
    if (values.count != count ||
        (values.components != components && values.components != or_components)) {
      json_.fail(std::string("the accessor of ") + key + " has not the size it should have");
    }
    return values;
  }

  void add_vertices(const Json& attributes, std::size_t position, const Mat4& world) {
    const std::size_t base = mesh_.positions.size(), count = accessors_.count(position);
    const auto p = read_attribute(attributes, "POSITION", count, 3, 3);
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector4d x(p.values[3 * i], p.values[3 * i + 1], p.values[3 * i + 2], 1);
      mesh_.positions.push_back((world * x).head<3>());
      if (!mesh_.positions.back().allFinite()) json_.fail("a transformed vertex is not finite");
    }
    if (attributes.contains("NORMAL")) {
      const auto n = read_attribute(attributes, "NORMAL", count, 3, 3);
      // Normals follow the cofactors, which equal the inverse transposed times the determinant.
      const Mat3 m = world.topLeftCorner<3, 3>();
      Mat3 cofactors;
      cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
      const double sign = m.determinant() < 0 ? -1 : 1;
      normals_.resize(base, Vec3::Zero());
      for (std::size_t i = 0; i < count; ++i) {
        const Vec3 normal(n.values[3 * i], n.values[3 * i + 1], n.values[3 * i + 2]);
        normals_.push_back(sign * cofactors * normal);
      }
    }
    if (attributes.contains("TEXCOORD_0")) {
      const auto uv = read_attribute(attributes, "TEXCOORD_0", count, 2, 2);
      uvs_.resize(base, Vec2::Zero());
      for (std::size_t i = 0; i < count; ++i) {
        uvs_.emplace_back(uv.values[2 * i], 1 - uv.values[2 * i + 1]);
      }
    }
    if (attributes.contains("COLOR_0")) {
      const auto c = read_attribute(attributes, "COLOR_0", count, 3, 4);
      mesh_.vertex_colors.resize(base, Color{1, 1, 1, 1});
      for (std::size_t i = 0; i < count; ++i) {
        Color& color = mesh_.vertex_colors.emplace_back(Color{1, 1, 1, 1});
        for (std::size_t k = 0; k < c.components; ++k) {
          color[k] = static_cast<float>(std::clamp(c.values[c.components * i + k], 0.0, 1.0));
        }
      }
    }
    for (const auto& [key, value] : attributes.items()) {
      if (key.starts_with('_')) add_attribute(attributes, key, count, base);
    }
  }

  void add_attribute(const Json& attributes, const std::string& key, std::size_t count,
                     std::size_t base) {
    auto values = accessors_.read(*json_.index(attributes, key.c_str()));
    if (values.count != count) json_.fail("the accessor of an attribute has the wrong count");
    std::string name = key.substr(1);
    for (char& c : name) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    auto& all = mesh_.vertex_attributes;
    auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& a) { return a.name == name; });
    if (found == all.end()) {
      spend(base * values.components);
      all.push_back({name, static_cast<int>(values.components), {}});
      found = all.end() - 1;
    }
    const auto n = static_cast<std::size_t>(found->components);
    if (n != values.components) json_.fail("'" + printable(key) + "' is of two sizes");
    found->values.resize(n * base, 0.0);
    found->values.insert(found->values.end(), values.values.begin(), values.values.end());
  }

  /// Vertices of primitives that lack what others have get its default; then to the corners.
  void fill_gaps() {
    const std::size_t count = mesh_.positions.size();
    if (!mesh_.vertex_colors.empty()) mesh_.vertex_colors.resize(count, Color{1, 1, 1, 1});
    for (Attribute& a : mesh_.vertex_attributes) {
      a.values.resize(static_cast<std::size_t>(a.components) * count, 0.0);
    }
    if (!uvs_.empty()) uvs_.resize(count, Vec2::Zero());
    if (!normals_.empty()) normals_.resize(count, Vec3::Zero());
    for (const Triangle& t : mesh_.triangles) {
      for (const std::int32_t v : t) {
        if (!uvs_.empty()) mesh_.corner_uvs.push_back(uvs_[v]);
        if (!normals_.empty()) mesh_.corner_normals.push_back(normals_[v]);
      }
    }
    if (mesh_.material_names.empty()) mesh_.face_materials.clear();
  }

  const std::string& name_;
  GltfJson json_;
  Chunks chunks_;
  Json root_;
  GltfAccessors accessors_;
  std::size_t budget_;  ///< vertices and indices that may still be added
  SurfaceMesh mesh_;
  std::vector<Vec2> uvs_;      ///< per vertex
  std::vector<Vec3> normals_;  ///< per vertex, zero where not given
};

}  // namespace

SurfaceMesh read_gltf(std::string_view bytes, const std::string& name, const GltfLoader& loader) {
  return GltfReader(bytes, name, loader).read();
}

}  // namespace craze
