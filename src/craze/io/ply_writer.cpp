#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "craze/io/byte_order.h"
#include "craze/io/ply.h"
#include "craze/io/unify_corners.h"

namespace craze {

namespace {

/// The scalar properties of one element: each has a name, a type and a way to append a row's value.
class PropertyList {
 public:
  explicit PropertyList(std::set<std::string> reserved = {}) : names_(std::move(reserved)) {}

  void add(const std::string& name, const char* type,
           std::function<void(std::string&, std::size_t)> append_row) {
    header_ += fmt::format("property {} {}\n", type, unique(name));
    appenders_.push_back(std::move(append_row));
  }

  void add_double(const std::string& name, std::function<double(std::size_t)> value) {
    add(name, "double",
        [value = std::move(value)](std::string& bytes, std::size_t i) { append(bytes, value(i)); });
  }

  /// `row` maps a written row to the attribute's.
  template <class Row>
  void add_attribute(const Attribute& a, Row row) {
    for (int k = 0; k < a.components; ++k) {
      add_double(a.components == 1 ? a.name : a.name + "_" + std::to_string(k),
                 [&a, k, row](std::size_t i) { return a.values[a.components * row(i) + k]; });
    }
  }

  const std::string& header() const { return header_; }
  void append_row(std::string& bytes, std::size_t i) const {
    for (const auto& appender : appenders_) appender(bytes, i);
  }

 private:
  /// A word of letters, digits and _ that no other property has.
  std::string unique(std::string name) {
    for (char& c : name) {
      if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    }
    if (name.empty()) name = "unnamed";
    while (!names_.insert(name).second) name += '_';
    return name;
  }

  std::set<std::string> names_;
  std::string header_;
  std::vector<std::function<void(std::string&, std::size_t)>> appenders_;
};

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, '_');
  return text;
}

}  // namespace

std::string format_ply(const SurfaceMesh& mesh) {
  const UnifiedCorners unified = unify_corners(mesh);
  const auto source = [&](std::size_t i) { return static_cast<std::size_t>(unified.sources[i]); };

  PropertyList vertex;
  for (int k = 0; k < 3; ++k) {
    vertex.add_double(std::string(1, "xyz"[k]),
                      [&mesh, source, k](std::size_t i) { return mesh.positions[source(i)][k]; });
  }
  for (int k = 0; k < 3 && !unified.normals.empty(); ++k) {
    vertex.add_double(std::string("n") + "xyz"[k],
                      [&unified, k](std::size_t i) { return unified.normals[i][k]; });
  }
  for (int k = 0; k < 2 && !unified.uvs.empty(); ++k) {
    vertex.add_double(std::string(1, "st"[k]),
                      [&unified, k](std::size_t i) { return unified.uvs[i][k]; });
  }
  const char* colors[] = {"red", "green", "blue", "alpha"};
  for (int k = 0; k < 4 && !mesh.vertex_colors.empty(); ++k) {
    vertex.add(colors[k], "uchar", [&mesh, source, k](std::string& bytes, std::size_t i) {
      const float c = std::clamp(mesh.vertex_colors[source(i)][k], 0.0f, 1.0f);
      append(bytes, static_cast<std::uint8_t>(std::lround(255 * c)));
    });
  }
  for (const Attribute& a : mesh.vertex_attributes) vertex.add_attribute(a, source);

  PropertyList face({"vertex_indices"});
  if (!mesh.face_materials.empty()) {
    face.add("material_index", "int",
             [&mesh](std::string& bytes, std::size_t f) { append(bytes, mesh.face_materials[f]); });
  }
  for (const Attribute& a : mesh.face_attributes) {
    face.add_attribute(a, [](std::size_t f) { return f; });
  }

  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment craze\n";
  for (const std::string& material : mesh.material_names) {
    bytes += fmt::format("comment material {}\n", one_line(material));
  }
  bytes += fmt::format(
      "element vertex {}\n{}element face {}\nproperty list uchar int "
      "vertex_indices\n{}end_header\n",
      unified.sources.size(), vertex.header(), mesh.triangles.size(), face.header());
  for (std::size_t i = 0; i < unified.sources.size(); ++i) vertex.append_row(bytes, i);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    append(bytes, std::uint8_t{3});
    for (const std::int32_t v : unified.triangles[f]) append(bytes, v);
    face.append_row(bytes, f);
  }
  return bytes;
}

}  // namespace craze
