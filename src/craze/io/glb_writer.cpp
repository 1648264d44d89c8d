// Format: Khronos Group, "glTF 2.0 Specification", 2021.
#include "craze/io/glb_writer.h"

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "craze/base/error.h"
#include "craze/io/byte_order.h"
#include "craze/io/polygon_soup.h"
#include "craze/io/single_precision.h"
#include "craze/io/unify_corners.h"

namespace craze {

namespace {

using nlohmann::ordered_json;

constexpr int float_component = 5126, uint_component = 5125;
constexpr int array_buffer = 34962, element_array_buffer = 34963;

float to_float(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -most, most));
}

/// The BIN chunk with the views and accessors into it.
class Buffer {
 public:
  /// Starts an accessor of `count` elements; its numbers are appended to bytes next.
  std::size_t begin(const char* type, int component, std::size_t count, int target) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", 0}, {"target", target}});
    accessors.push_back({{"bufferView", views_.size() - 1},
                         {"componentType", component},
                         {"count", count},
                         {"type", type}});
    return accessors.size() - 1;
  }
  void end() {
    const std::size_t offset = views_.back()["byteOffset"];
    views_.back()["byteLength"] = bytes.size() - offset;
  }
  const ordered_json& views() const { return views_; }

  std::string bytes;
  ordered_json accessors = ordered_json::array();

 private:
  ordered_json views_ = ordered_json::array();
};

/// "_CRACK_DISTANCE" for "crack distance".
std::string attribute_name(const std::string& name) {
  std::string result = "_";
  for (const char c : name) {
    const bool is_lower = c >= 'a' && c <= 'z';
    const bool is_kept = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    result += is_lower ? static_cast<char>(c - 'a' + 'A') : is_kept ? c : '_';
  }
  return result;
}

class GlbWriter {
 public:
  explicit GlbWriter(const SurfaceMesh& mesh) : mesh_(mesh), unified_(unify_corners(mesh)) {}

  std::string write() {
    write_attributes();
    write_primitives();
    if (buffer_.bytes.size() > std::numeric_limits<std::uint32_t>::max() - (1u << 24)) {
      throw Error(ErrorKind::request, "cannot write mesh", "GLB", "it would take more than 4 GB");
    }
    ordered_json root;
    root["asset"] = {{"version", "2.0"}, {"generator", "craze"}};
    root["scene"] = 0;
    root["scenes"] = {{{"nodes", {0}}}};
    root["nodes"] = {{{"mesh", 0}}};
    root["meshes"] = {{{"primitives", primitives_}}};
    root["materials"] = materials_;
    root["accessors"] = buffer_.accessors;
    root["bufferViews"] = buffer_.views();
    root["buffers"] = {{{"byteLength", buffer_.bytes.size()}}};
    return pack(root.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  }

 private:
  std::size_t count() const { return unified_.sources.size(); }

  void write_attributes() {
    write_positions();
    if (!unified_.normals.empty()) {
      attributes_["NORMAL"] = buffer_.begin("VEC3", float_component, count(), array_buffer);
      for (const Vec3& n : unified_.normals) {
        for (int k = 0; k < 3; ++k) append(buffer_.bytes, to_float(n[k]));
      }
      buffer_.end();
    }
    if (!unified_.uvs.empty()) {
      attributes_["TEXCOORD_0"] = buffer_.begin("VEC2", float_component, count(), array_buffer);
      for (const Vec2& uv : unified_.uvs) {
        append(buffer_.bytes, to_float(uv.x()));
        append(buffer_.bytes, to_float(1 - uv.y()));
      }
      buffer_.end();
    }
    if (!mesh_.vertex_colors.empty()) {
      attributes_["COLOR_0"] = buffer_.begin("VEC4", float_component, count(), array_buffer);
      for (const std::int32_t v : unified_.sources) {
        for (const float c : mesh_.vertex_colors[v]) {
          append(buffer_.bytes, std::clamp(c, 0.0f, 1.0f));
        }
      }
      buffer_.end();
    }
    for (const Attribute& a : mesh_.vertex_attributes) write_attribute(a);
  }

  void write_positions() {
    const std::size_t accessor = buffer_.begin("VEC3", float_component, count(), array_buffer);
    attributes_["POSITION"] = accessor;
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (const std::int32_t v : unified_.sources) {
      const auto p = to_floats(mesh_.positions[v], "GLB");
      for (std::size_t k = 0; k < 3; ++k) {
        append(buffer_.bytes, p[k]);
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
    buffer_.end();
    buffer_.accessors[accessor]["min"] = low;
    buffer_.accessors[accessor]["max"] = high;
  }

  void write_attribute(const Attribute& a) {
    const bool fits = a.components <= 4;
    const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    for (int first = 0; first < a.components; first += fits ? a.components : 1) {
      std::string name = attribute_name(fits ? a.name : a.name + "_" + std::to_string(first));
      while (attributes_.contains(name)) name += '_';
      const int n = fits ? a.components : 1;
      attributes_[name] = buffer_.begin(types[n - 1], float_component, count(), array_buffer);
      for (const std::int32_t v : unified_.sources) {
        const double* values = &a.values[static_cast<std::size_t>(a.components) * v + first];
        for (int k = 0; k < n; ++k) append(buffer_.bytes, to_float(values[k]));
      }
      buffer_.end();
    }
  }

  void write_primitives() {
    std::map<std::int32_t, std::vector<std::size_t>> faces_of;  // −1, no material, comes first
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      faces_of[mesh_.face_materials.empty() ? -1 : mesh_.face_materials[f]].push_back(f);
    }
    for (const auto& [material, faces] : faces_of) {
      const std::size_t indices =
          buffer_.begin("SCALAR", uint_component, 3 * faces.size(), element_array_buffer);
      for (const std::size_t f : faces) {
        for (const std::int32_t v : unified_.triangles[f]) {
          append(buffer_.bytes, static_cast<std::uint32_t>(v));
        }
      }
      buffer_.end();
      primitives_.push_back(
          {{"attributes", attributes_}, {"indices", indices}, {"material", materials_.size()}});
      add_material(material < 0 ? "surface" : mesh_.material_names[material]);
    }
  }

  void add_material(const std::string& name) {
    // Colours of vertices are multiplied by the material's.
    const double grey = mesh_.vertex_colors.empty() ? 0.8 : 1.0;
    materials_.push_back({{"name", name},
                          {"pbrMetallicRoughness",
                           {{"baseColorFactor", {grey, grey, grey, 1.0}},
                            {"metallicFactor", 0.0},
                            {"roughnessFactor", 0.8}}},
                          {"doubleSided", true}});
  }

  std::string pack(std::string json) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string& bin = buffer_.bytes;
    bin.resize((bin.size() + 3) / 4 * 4, '\0');
    std::string bytes;
    bytes.reserve(28 + json.size() + bin.size());
    bytes += "glTF";
    append(bytes, std::uint32_t{2});
    append(bytes, static_cast<std::uint32_t>(28 + json.size() + bin.size()));
    append(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON";
    bytes += json;
    append(bytes, static_cast<std::uint32_t>(bin.size()));
    bytes.append("BIN\0", 4);
    bytes += bin;
    return bytes;
  }

  const SurfaceMesh& mesh_;
  UnifiedCorners unified_;
  Buffer buffer_;
  ordered_json attributes_ = ordered_json::object();
  ordered_json primitives_ = ordered_json::array(), materials_ = ordered_json::array();
};

}  // namespace

std::string format_glb(const SurfaceMesh& mesh) {
  if (mesh.corner_normals.empty()) return GlbWriter(mesh).write();
  SurfaceMesh unit = mesh;
  normalize_corner_normals(unit);
  return GlbWriter(unit).write();
}

}  // namespace craze
