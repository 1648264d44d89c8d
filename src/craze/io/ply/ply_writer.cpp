#include <algorithm>
#include <cmath>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/ply/ply.h"
#include "craze/io/ply/ply_properties.h"
#include "craze/io/ply/ply_scene.h"
#include "craze/io/polygons/unify_corners.h"

namespace craze {

namespace {

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, '_');
  return text;
}

/// Bits of each channel: as many as the file had, or as the colours need; 32 stands for fractions.
int color_bits(const std::vector<Color>& colors, const SourceScene* scene) {
  const int had = scene ? scene->color_bits() : 0;
  if (had == 8 || had == 16) return had;
  constexpr float rounding = 1e-4f;
  for (const Color& color : colors) {
    for (const float c : color) {
      if (std::abs(255 * c - std::round(255 * c)) > rounding) return 32;
    }
  }
  return 8;
}

/// Whether other programs take the attribute for a channel of the faces' colour, in whole numbers.
bool is_color_channel(const Attribute& a) {
  const bool named = a.name == "red" || a.name == "green" || a.name == "blue" || a.name == "alpha";
  return named && a.components == 1 && std::all_of(a.values.begin(), a.values.end(), [](double x) {
           return x >= 0 && x <= 255 && x == std::floor(x);
         });
}

}  // namespace

void write_ply(const SurfaceMesh& mesh, const MeshFileOptions& options, ByteSink& sink,
               const Context& context) {
  const UnifiedCorners unified = unify_corners(mesh);
  const auto source = [&](std::size_t i) { return static_cast<std::size_t>(unified.sources[i]); };

  PlyProperties vertex;
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
  const int bits = color_bits(mesh.vertex_colors, options.scene.get());
  const char* type = bits == 8 ? "uchar" : bits == 16 ? "ushort" : "float";
  for (int k = 0; k < 4 && !mesh.vertex_colors.empty(); ++k) {
    vertex.add(colors[k], type, [&mesh, source, k, bits](std::string& bytes, std::size_t i) {
      const float c = std::clamp(mesh.vertex_colors[source(i)][k], 0.0f, 1.0f);
      if (bits == 8) return append(bytes, static_cast<std::uint8_t>(std::lround(255 * c)));
      if (bits == 16) return append(bytes, static_cast<std::uint16_t>(std::lround(65535 * c)));
      append(bytes, c);
    });
  }
  for (const Attribute& a : mesh.vertex_attributes) vertex.add_attribute(a, source);

  PlyProperties face({"vertex_indices"});
  if (!mesh.face_materials.empty()) {
    face.add("material_index", "int",
             [&mesh](std::string& bytes, std::size_t f) { append(bytes, mesh.face_materials[f]); });
  }
  for (const Attribute& a : mesh.face_attributes) {
    if (is_color_channel(a)) {
      face.add(a.name, "uchar", [&a](std::string& bytes, std::size_t f) {
        append(bytes, static_cast<std::uint8_t>(a.values[f]));
      });
    } else {
      face.add_attribute(a);
    }
  }

  std::string& bytes = sink.pending();
  bytes += "ply\nformat binary_little_endian 1.0\ncomment craze\n";
  if (const auto* scene = dynamic_cast<const PlyScene*>(options.scene.get())) {
    for (const std::string& comment : scene->comments) bytes += "comment " + comment + "\n";
    for (const std::string& info : scene->infos) bytes += "obj_info " + info + "\n";
  }
  for (const std::string& material : mesh.material_names) {
    bytes += fmt::format("comment material {}\n", one_line(material));
  }
  bytes += fmt::format(
      "element vertex {}\n{}element face {}\nproperty list uchar int "
      "vertex_indices\n{}end_header\n",
      unified.sources.size(), vertex.header(), mesh.triangles.size(), face.header());
  ProgressMeter meter(context, "write", unified.sources.size() + mesh.triangles.size());
  for (std::size_t i = 0; i < unified.sources.size(); ++i) {
    meter.at(i);
    vertex.append_row(bytes, i);
    sink.pass_on();
  }
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    meter.at(unified.sources.size() + f);
    append(bytes, std::uint8_t{3});
    for (const std::int32_t v : unified.triangles[f]) append(bytes, v);
    face.append_row(bytes, f);
    sink.pass_on();
  }
}

}  // namespace craze
