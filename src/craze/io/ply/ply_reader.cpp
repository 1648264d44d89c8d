#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/ply/ply.h"
#include "craze/io/ply/ply_rows.h"
#include "craze/io/ply/ply_scene.h"
#include "craze/io/polygons/polygon_soup.h"

namespace craze {

namespace {

bool is_float(PlyType type) {
  return type == PlyType::float32 || type == PlyType::float64;
}

/// What stands for 1 in channels of a kind. Floats are 0 … 1, some a little over or bright beyond
/// it, or 0 … 255: whole numbers, or far over.
double color_scale(PlyRows& rows, const std::vector<std::string>& channels) {
  constexpr double clearly_above_one = 2, above_all_light = 16;
  double scale = 1, largest = 0;
  bool whole = true;
  for (const std::string& channel : channels) {
    const PlyType type = rows.type(channel);
    if (!is_float(type)) scale = std::max(scale, type == PlyType::uint16 ? 65535.0 : 255.0);
    for (const double x : rows.take(channel)) {
      largest = std::max(largest, x);
      whole = whole && x == std::floor(x);
    }
  }
  if (scale > 1) return scale;
  return largest > above_all_light || (largest > clearly_above_one && whole) ? 255 : 1;
}

struct VertexColors {
  std::vector<Color> colors;
  int bits = 0;             ///< as SourceScene::color_bits()
  std::size_t bounded = 0;  ///< channels that were not within 0 … 1
};

VertexColors take_colors(PlyRows& rows) {
  const std::array<const char*, 4> synonyms[] = {
      {"red", "green", "blue", "alpha"},
      {"r", "g", "b", "a"},
      {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}};
  VertexColors taken;
  for (const auto& names : synonyms) {
    if (!rows.has_all({names[0], names[1], names[2]})) continue;
    taken.colors.assign(rows.count(), Color{1, 1, 1, 1});
    double scale = color_scale(rows, {names[0], names[1], names[2]});
    for (std::size_t c = 0; c < 4; ++c) {
      if (!rows.has(names[c])) continue;
      const PlyType type = rows.type(names[c]);
      const std::vector<double>& values = rows.take(names[c]);
      if (c == 3) scale = color_scale(rows, {names[c]});
      const bool whole =
          std::all_of(values.begin(), values.end(), [](double x) { return x == std::floor(x); });
      const int of_floats = scale == 255 && whole ? 8 : 32;
      const int of_type = type == PlyType::uint16 ? 16 : 8;
      taken.bits = std::max(taken.bits, is_float(type) ? of_floats : of_type);
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = values[i] / scale, inside = std::clamp(value, 0.0, 1.0);
        taken.bounded += std::abs(value - inside) > 1e-6;
        taken.colors[i][c] = static_cast<float>(inside);
      }
    }
    return taken;
  }
  return taken;
}

/// Calls visit(a, b, c) for the triangles of strips, the turn of every other one undone. A negative
/// index, or the largest one, ends a strip.
template <class Visit>
void for_each_triangle_of_strips(const PlyColumn& strips, Visit visit) {
  constexpr double largest = 4294967295.0;
  std::size_t begin = 0;
  for (const std::size_t end : strips.ends) {
    std::size_t start = begin;
    for (std::size_t i = begin; i < end; ++i) {
      if (strips.values[i] < 0 || strips.values[i] == largest) {
        start = i + 1;
      } else if (i >= start + 2) {
        const bool turned = (i - start) % 2 == 1;
        const double a = strips.values[i - 2], b = strips.values[i - 1], c = strips.values[i];
        const bool joins_strips = a == b || b == c || a == c;
        if (!joins_strips) visit(turned ? b : a, turned ? a : b, c);
      }
    }
    begin = end;
  }
}

std::int32_t to_index(double value) {
  // −2 is out of any range, and unlike −1 never means "none".
  return value == std::floor(value) && value >= 0 && value < 2147483647.0
             ? static_cast<std::int32_t>(value)
             : -2;
}

class PlyReader {
 public:
  explicit PlyReader(const MeshSource& source)
      : source_(source), bytes_(source.bytes), name_(source.name) {}

  SurfaceMesh read() {
    const PlyHeader header = parse_ply_header(bytes_, name_);
    PlyBody body(source_, header);
    for (const PlyElement& element : header.elements) {
      if (element.name != "vertex" && element.name != "face" && element.name != "tristrips") {
        body.read(element);
        if (element.count > 0) {
          source_.warn(fmt::format("the {} rows of '{}' are not kept", element.count,
                                   printable(element.name)));
        }
        continue;
      }
      PlyRows rows(element, body.read(element), name_);
      if (element.name == "vertex") {
        read_vertices(rows);
      } else if (element.name == "face") {
        read_faces(rows, header);
      } else {
        read_strips(rows);
      }
      warn_of_lists(rows, element);
      rows.warn_of_mended(source_);
    }
    if (body.surplus_rows() > 0) {
      source_.warn(
          fmt::format("{} rows hold more numbers than the header declares; these are not "
                      "read",
                      body.surplus_rows()));
    }
    if (const std::size_t bytes = body.unread(); bytes > 0) {
      source_.warn(fmt::format("{} bytes after the last row are not read", bytes));
    }
    add_strips();
    link_corners();
    const bool has_uvs = !soup_.uvs.empty();
    SurfaceMesh mesh = triangulate(std::move(soup_), source_);
    mesh.vertex_colors = std::move(colors_);
    mesh.vertex_attributes = std::move(vertex_attributes_);
    if (!mesh.face_materials.empty()) mesh.material_names = header.materials;
    for (const Attribute& a : face_attributes_) {
      mesh.face_attributes.push_back(spread(a, mesh.source_faces));
    }
    if (has_uvs && header.materials.empty()) give_textures(header, mesh);
    keep_scene(header, mesh);
    return mesh;
  }

 private:
  /// A material for each texture, where faces say which is theirs or there is only one.
  void give_textures(const PlyHeader& header, SurfaceMesh& mesh) const {
    const std::vector<std::string> names = texture_materials(header);
    const Attribute* numbers = find_attribute(mesh.face_attributes, "texnumber");
    if (names.empty()) return;
    if (names.size() > 1 && !numbers) {
      source_.warn(fmt::format(
          "{} textures are named, and no face says which is its own (texnumber)", names.size()));
      return;
    }
    mesh.material_names = names;
    mesh.face_materials.assign(mesh.triangles.size(), 0);
    for (std::size_t f = 0; names.size() > 1 && f < mesh.triangles.size(); ++f) {
      const std::int32_t number = to_index(numbers->values[f]);
      const bool is_one = number >= 0 && static_cast<std::size_t>(number) < names.size();
      mesh.face_materials[f] = is_one ? number : -1;
    }
  }

  void keep_scene(const PlyHeader& header, const SurfaceMesh& mesh) const {
    source_.textures = header.textures;
    if (bounded_colors_ > 0) {
      source_.warn(fmt::format("{} channels of colours go beyond 0 to 1; they are bounded to it",
                               bounded_colors_));
    }
    if (header.comments.empty() && header.infos.empty() && color_bits_ == 0) {
      return;
    }
    const auto scene = std::make_shared<PlyScene>();
    scene->folder = std::filesystem::path(name_).parent_path();
    scene->comments = header.comments;
    scene->infos = header.infos;
    scene->bits = color_bits_;
    bring_textures(mesh.material_names, header, source_, *scene);
    if (source_.looks && !scene->looks.empty()) *source_.looks = scene->looks;
    source_.scene = scene;
  }

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
        {"s", "t"},         {"u", "v"},  {"texture_u", "texture_v"}, {"texture_s", "texture_t"},
        {"tex_u", "tex_v"}, {"tu", "tv"}};
    for (const auto& [u_name, v_name] : uv_names) {
      if (!vertex_uvs_.empty() || !rows.has(u_name) || !rows.has(v_name)) continue;
      const auto &u = rows.take(u_name), &v = rows.take(v_name);
      for (std::size_t i = 0; i < rows.count(); ++i) vertex_uvs_.emplace_back(u[i], v[i]);
    }
    VertexColors taken = take_colors(rows);
    colors_ = std::move(taken.colors);
    color_bits_ = taken.bits;
    bounded_colors_ = taken.bounded;
    vertex_attributes_ = rows.attributes();
  }

  void read_faces(PlyRows& rows, const PlyHeader& header) {
    if (!soup_.ends.empty()) fail_input(name_, "it has two 'face' elements");
    const PlyColumn& indices = take_indices(rows, "faces");
    soup_.ends = indices.ends;
    soup_.corners.reserve(indices.values.size());
    for (const double value : indices.values) soup_.corners.push_back({to_index(value), -1, -1});
    if (rows.has("texcoord", true)) read_face_uvs(rows.take_list("texcoord"));
    if (rows.has("material_index") && !header.materials.empty()) {
      read_materials(rows.take("material_index"), header.materials.size());
    }
    face_attributes_ = rows.attributes();
  }

  const PlyColumn& take_indices(PlyRows& rows, const char* what) const {
    for (const char* list : {"vertex_indices", "vertex_index"}) {
      if (rows.has(list, true)) return rows.take_list(list);
    }
    fail_input(name_, fmt::format("its {} lack vertex_indices", what));
  }

  void read_strips(PlyRows& rows) {
    for_each_triangle_of_strips(take_indices(rows, "tristrips"), [&](double a, double b, double c) {
      for (const double i : {a, b, c}) strips_.push_back(to_index(i));
    });
  }

  /// The triangles of strips come after the faces. They have no attributes of their own.
  void add_strips() {
    const bool has_materials = !soup_.materials.empty();
    for (std::size_t i = 0; i < strips_.size(); i += 3) {
      for (std::size_t k = 0; k < 3; ++k) soup_.corners.push_back({strips_[i + k], -1, -1});
      soup_.close_polygon();
      if (has_materials) soup_.materials.push_back(-1);
    }
    for (Attribute& a : face_attributes_) {
      a.values.resize(soup_.ends.size() * static_cast<std::size_t>(a.components), 0.0);
    }
  }

  void warn_of_lists(const PlyRows& rows, const PlyElement& element) const {
    for (const std::string& list : rows.lists_left()) {
      source_.warn(fmt::format("the lists '{}' of '{}' are not kept", printable(list),
                               printable(element.name)));
    }
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

  const MeshSource& source_;
  std::string_view bytes_;
  const std::string& name_;
  PolygonSoup soup_;
  std::vector<Vec2> vertex_uvs_;
  std::vector<std::int32_t> strips_;  ///< vertices of their triangles
  std::vector<Color> colors_;
  int color_bits_ = 0;
  std::size_t bounded_colors_ = 0;
  std::vector<Attribute> vertex_attributes_, face_attributes_;
};

}  // namespace

bool is_ply(std::string_view bytes) {
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
}

SurfaceMesh read_ply(const MeshSource& source) {
  return PlyReader(source).read();
}

}  // namespace craze
