#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "craze/io/bytes/input_error.h"
#include "craze/io/ply/ply.h"
#include "craze/io/ply/ply_rows.h"
#include "craze/io/polygons/polygon_soup.h"

namespace craze {

namespace {

bool is_float(PlyType type) {
  return type == PlyType::float32 || type == PlyType::float64;
}

std::vector<Color> take_colors(PlyRows& rows) {
  if (!rows.has_all({"red", "green", "blue"})) return {};
  std::vector<Color> colors(rows.count(), Color{1, 1, 1, 1});
  const char* names[] = {"red", "green", "blue", "alpha"};
  for (std::size_t c = 0; c < 4; ++c) {
    if (!rows.has(names[c])) continue;
    const PlyType type = rows.type(names[c]);
    const double scale = is_float(type) ? 1 : type == PlyType::uint16 ? 65535 : 255;
    const std::vector<double>& values = rows.take(names[c]);
    for (std::size_t i = 0; i < values.size(); ++i) {
      colors[i][c] = static_cast<float>(std::clamp(values[i] / scale, 0.0, 1.0));
    }
  }
  return colors;
}

std::int32_t to_index(double value) {
  // −2 is out of any range, and unlike −1 never means "none".
  return value == std::floor(value) && value >= 0 && value < 2147483647.0
             ? static_cast<std::int32_t>(value)
             : -2;
}

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  SurfaceMesh read() {
    const PlyHeader header = parse_ply_header(bytes_, name_);
    PlyBody body(bytes_, header, name_);
    for (const PlyElement& element : header.elements) {
      if (element.name != "vertex" && element.name != "face") {
        body.read(element);
        continue;
      }
      PlyRows rows(element, body.read(element), name_);
      if (element.name == "vertex") {
        read_vertices(rows);
      } else {
        read_faces(rows, header);
      }
    }
    link_corners();
    SurfaceMesh mesh = triangulate(std::move(soup_), name_);
    mesh.vertex_colors = std::move(colors_);
    mesh.vertex_attributes = std::move(vertex_attributes_);
    if (!mesh.face_materials.empty()) mesh.material_names = header.materials;
    for (const Attribute& a : face_attributes_) {
      mesh.face_attributes.push_back(spread(a, mesh.source_faces));
    }
    return mesh;
  }

 private:
  void read_vertices(PlyRows& rows) {
    if (!soup_.positions.empty()) fail_input(name_, "it has two 'vertex' elements");
    if (!rows.has_all({"x", "y", "z"})) fail_input(name_, "its vertices lack x, y or z");
    const auto &x = rows.take("x"), &y = rows.take("y"), &z = rows.take("z");
    soup_.positions.reserve(rows.count());
    for (std::size_t i = 0; i < rows.count(); ++i) soup_.positions.emplace_back(x[i], y[i], z[i]);
    if (rows.has_all({"nx", "ny", "nz"})) {
      const auto &nx = rows.take("nx"), &ny = rows.take("ny"), &nz = rows.take("nz");
      soup_.normals.reserve(rows.count());
      for (std::size_t i = 0; i < rows.count(); ++i) {
        soup_.normals.emplace_back(nx[i], ny[i], nz[i]);
      }
    }
    const std::pair<const char*, const char*> uv_names[] = {
        {"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};
    for (const auto& [u_name, v_name] : uv_names) {
      if (!vertex_uvs_.empty() || !rows.has(u_name) || !rows.has(v_name)) continue;
      const auto &u = rows.take(u_name), &v = rows.take(v_name);
      for (std::size_t i = 0; i < rows.count(); ++i) vertex_uvs_.emplace_back(u[i], v[i]);
    }
    colors_ = take_colors(rows);
    vertex_attributes_ = rows.attributes();
  }

  void read_faces(PlyRows& rows, const PlyHeader& header) {
    if (!soup_.ends.empty()) fail_input(name_, "it has two 'face' elements");
    const char* list = rows.has("vertex_indices", true) ? "vertex_indices" : "vertex_index";
    if (!rows.has(list, true)) fail_input(name_, "its faces lack vertex_indices");
    const PlyColumn& indices = rows.take_list(list);
    soup_.ends = indices.ends;
    soup_.corners.reserve(indices.values.size());
    for (const double value : indices.values) soup_.corners.push_back({to_index(value), -1, -1});
    if (rows.has("texcoord", true)) read_face_uvs(rows.take_list("texcoord"));
    if (rows.has("material_index") && !header.materials.empty()) {
      read_materials(rows.take("material_index"), header.materials.size());
    }
    face_attributes_ = rows.attributes();
  }

  void read_face_uvs(const PlyColumn& texcoord) {
    std::size_t begin = 0, corner = 0;
    for (std::size_t f = 0; f < soup_.ends.size(); ++f) {
      const std::size_t numbers = texcoord.ends[f] - begin, corners = soup_.ends[f] - corner;
      if (numbers != 0 && numbers != 2 * corners) {
        fail_input(name_, fmt::format("face {} has {} corners but {} texcoord numbers", f, corners,
                                      numbers));
      }
      for (std::size_t i = 0; i < numbers / 2; ++i) {
        soup_.corners[corner + i].uv = static_cast<std::int32_t>(soup_.uvs.size());
        soup_.uvs.emplace_back(texcoord.values[begin + 2 * i], texcoord.values[begin + 2 * i + 1]);
      }
      begin = texcoord.ends[f];
      corner = soup_.ends[f];
    }
  }

  void read_materials(const std::vector<double>& indices, std::size_t count) {
    soup_.materials.reserve(indices.size());
    for (std::size_t f = 0; f < indices.size(); ++f) {
      const std::int32_t index = indices[f] == -1 ? -1 : to_index(indices[f]);
      if (index < -1 || (index >= 0 && static_cast<std::size_t>(index) >= count)) {
        fail_input(name_, fmt::format("face {} has a material_index out of range", f));
      }
      soup_.materials.push_back(index);
    }
  }

  /// Values per vertex belong to the corners there. A face's own UVs win.
  void link_corners() {
    const bool face_uvs = !soup_.uvs.empty();
    if (!face_uvs) soup_.uvs = std::move(vertex_uvs_);
    for (SoupCorner& c : soup_.corners) {
      if (!soup_.normals.empty()) c.normal = c.vertex;
      if (!face_uvs && !soup_.uvs.empty()) c.uv = c.vertex;
    }
  }

  static Attribute spread(const Attribute& per_polygon, const std::vector<std::int32_t>& sources) {
    Attribute a{per_polygon.name, per_polygon.components, {}};
    const auto n = static_cast<std::size_t>(a.components);
    a.values.reserve(n * sources.size());
    for (const std::int32_t source : sources) {
      for (std::size_t k = 0; k < n; ++k) a.values.push_back(per_polygon.values[n * source + k]);
    }
    return a;
  }

  std::string_view bytes_;
  const std::string& name_;
  PolygonSoup soup_;
  std::vector<Vec2> vertex_uvs_;
  std::vector<Color> colors_;
  std::vector<Attribute> vertex_attributes_, face_attributes_;
};

}  // namespace

SurfaceMesh read_ply(std::string_view bytes, const std::string& name) {
  return PlyReader(bytes, name).read();
}

}  // namespace craze
