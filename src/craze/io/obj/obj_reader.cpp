// Format: Wavefront Technologies, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <unordered_map>

#include "craze/base/progress_meter.h"
#include "craze/error.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/bytes/text_cursor.h"
#include "craze/io/image/picture_type.h"
#include "craze/io/obj/mtl.h"
#include "craze/io/obj/obj.h"
#include "craze/io/obj/obj_scene.h"
#include "craze/io/polygons/polygon_soup.h"

namespace craze {

namespace {

/// Bytes between two looks at the clock.
constexpr std::size_t meter_step = std::size_t{1} << 20;

constexpr std::size_t longest_keyword = 20, most_kinds_named = 8;

class ObjReader {
 public:
  explicit ObjReader(const MeshSource& source)
      : source_(source), text_(source.bytes, source.name) {}

  SurfaceMesh read() {
    ProgressMeter meter(source_.context, "load", source_.bytes.size(), meter_step);
    while (text_.skip_blank()) {
      meter.at(text_.offset());
      const std::string_view keyword = text_.word();
      if (keyword == "v") {
        read_vertex();
      } else if (keyword == "vt") {
        read_uv();
      } else if (keyword == "vn") {
        read_normal();
      } else if (keyword == "f") {
        read_face();
      } else if (keyword == "usemtl") {
        use_material(text_.rest_of_line());
      } else if (keyword == "mtllib") {
        name_library(std::string(text_.rest_of_line()));
      } else if (keyword == "o") {
        object_ = text_.rest_of_line();
        group_.clear();
        is_new_object_ = true;
      } else if (keyword == "g") {
        group_ = text_.rest_of_line();
        is_new_object_ = true;
      } else if (!keyword.empty() && keyword != "s") {
        leave_out(keyword);
      }
      text_.skip_line();
    }
    SurfaceMesh mesh = triangulate(std::move(soup_), source_);
    warn_of_left_out();
    mesh.material_names = std::move(material_names_);
    mesh.object_names = std::move(object_names_);
    keep_scene(mesh);
    if (!colors_.empty()) {
      colors_.resize(mesh.positions.size(), Color{1, 1, 1, 1});
      mesh.vertex_colors = std::move(colors_);
    }
    return mesh;
  }

 private:
  /// x y z, then nothing, w, r g b or r g b a.
  void read_vertex() {
    double n[7] = {};
    int count = 0;
    while (count < 3 || (count < 7 && text_.more_on_line())) {
      n[count++] = text_.number("a coordinate");
    }
    soup_.positions.emplace_back(n[0], n[1], n[2]);
    if (count >= 6) {
      const auto unit = [](double c) { return static_cast<float>(std::clamp(c, 0.0, 1.0)); };
      colors_.resize(soup_.positions.size() - 1, Color{1, 1, 1, 1});
      colors_.push_back({unit(n[3]), unit(n[4]), unit(n[5]), count == 7 ? unit(n[6]) : 1.0f});
    }
  }

  void read_uv() {
    const double u = text_.number("a texture coordinate");
    soup_.uvs.emplace_back(u, text_.more_on_line() ? text_.number("a texture coordinate") : 0.0);
  }

  void read_normal() {
    const double x = text_.number("a normal"), y = text_.number("a normal");
    soup_.normals.emplace_back(x, y, text_.number("a normal"));
  }

  /// Corners V, V/VT, V//VN or V/VT/VN; what is behind a slash may be missing.
  void read_face() {
    if (is_new_object_) begin_object();
    while (text_.more_on_line()) {
      SoupCorner corner;
      corner.vertex = read_vertex_index();
      if (text_.accept('/')) {
        if (!text_.at_word_end() && !text_.is_at('/')) corner.uv = read_index_of(soup_.uvs.size());
        if (text_.accept('/') && !text_.at_word_end()) {
          corner.normal = read_index_of(soup_.normals.size());
        }
      }
      if (!text_.at_word_end()) text_.fail("a face's corner is not of the form V/VT/VN");
      soup_.corners.push_back(corner);
    }
    soup_.close_polygon();
    soup_.lines.push_back(text_.line());
    if (!material_names_.empty()) soup_.materials.push_back(material_);
    if (!object_names_.empty()) soup_.objects.push_back(object_index_);
  }

  /// Counted from 1, or backwards from −1, the last one read so far; the upper end is checked when
  /// all have been read.
  std::int32_t read_vertex_index() {
    const std::size_t count = soup_.positions.size();
    const std::int64_t i = text_.leading_integer("a face's index");
    const std::int64_t index = i < 0 ? static_cast<std::int64_t>(count) + i : i - 1;
    if (index < 0 || index >= std::numeric_limits<std::int32_t>::max()) {
      text_.fail(fmt::format("a face's index {} is out of range, {} are known here", i, count));
    }
    return static_cast<std::int32_t>(index);
  }

  /// The same of a UV or normal, which need not be there: −2 where none can be.
  std::int32_t read_index_of(std::size_t count) {
    const std::int64_t i = text_.leading_integer("a face's index");
    const std::int64_t index = i < 0 ? static_cast<std::int64_t>(count) + i : i - 1;
    const bool possible = index >= 0 && index < std::numeric_limits<std::int32_t>::max();
    return possible ? static_cast<std::int32_t>(index) : -2;
  }

  /// Kinds beyond those that will be named count as one.
  void leave_out(std::string_view keyword) {
    const std::string key(keyword.substr(0, longest_keyword));
    const auto known = left_out_.find(key);
    if (known != left_out_.end()) {
      ++known->second;
    } else if (left_out_.size() <= most_kinds_named) {
      left_out_.emplace(key, 1);
    }
  }

  /// Names, in one sentence, the kinds of lines that were skipped and how many there were.
  void warn_of_left_out() const {
    std::string list;
    std::size_t kinds = 0;
    for (const auto& [keyword, count] : left_out_) {
      if (++kinds > most_kinds_named) break;
      list += fmt::format("{}{} '{}'", list.empty() ? "" : ", ", count, printable(keyword));
    }
    if (list.empty()) return;
    source_.warn(fmt::format("lines of these kinds are not kept: {}{}", list,
                             kinds > most_kinds_named ? " and more" : ""));
  }

  void use_material(std::string_view material) {
    if (material == "(null)" || material.empty()) {
      material_ = -1;
      return;
    }
    if (material_names_.empty()) soup_.materials.assign(soup_.ends.size(), -1);
    const auto [found, is_new] = material_indices_.try_emplace(
        std::string(material), static_cast<std::int32_t>(material_names_.size()));
    if (is_new) material_names_.emplace_back(material);
    material_ = found->second;
  }

  /// One name that may hold spaces, or several.
  void name_library(const std::string& names) {
    const auto& known = scene_.libraries;
    if (names.empty() || std::find(known.begin(), known.end(), names) != known.end()) return;
    scene_.libraries.push_back(names);
    std::string text;
    if (bring(names, text)) {
      scene_.materials += text + "\n";
      return;
    }
    std::istringstream words(names);
    bool any = false;
    for (std::string name; words >> name;) {
      if (name == names || !bring(name, text)) continue;
      scene_.materials += text + "\n";
      any = true;
    }
    if (!any) {
      source_.warn(
          fmt::format("material library '{}' cannot be read; its materials are known by "
                      "name alone",
                      printable(names)));
    }
  }

  bool bring(const std::string& name, std::string& bytes) const {
    if (!source_.files) return false;
    try {
      bytes = source_.files(name);
      return true;
    } catch (const Error&) {
      return false;
    }
  }

  /// Keeps what the file says besides its surface, and the pictures of its colours.
  void keep_scene(const SurfaceMesh& mesh) {
    if (scene_.libraries.empty() && scene_.objects.empty()) return;
    scene_.folder = std::filesystem::path(source_.name).parent_path();
    const std::vector<MtlMaterial> materials = parse_mtl(scene_.materials);
    for (const MtlMaterial& material : materials) {
      const std::string& name = material.color_picture;
      if (name.empty() || scene_.pictures.count(name)) continue;
      std::string bytes;
      if (bring(name, bytes) && !picture_type(bytes).empty()) scene_.pictures[name] = bytes;
    }
    source_.scene = std::make_shared<const ObjScene>(std::move(scene_));
    if (source_.looks && !materials.empty()) *source_.looks = looks_of(mesh, materials);
  }

  static std::vector<MaterialLook> looks_of(const SurfaceMesh& mesh,
                                            const std::vector<MtlMaterial>& materials) {
    std::map<std::string, MaterialLook> known;
    for (const MtlMaterial& material : materials) {
      MaterialLook look;
      for (std::size_t k = 0; k < 3; ++k)
        look.base_color[k] = static_cast<float>(material.color[k]);
      look.base_color[3] = static_cast<float>(material.opacity);
      if (material.opacity < 1) look.alpha = MaterialLook::Alpha::blended;
      look.base_picture.file = material.color_picture;
      if (material.is_clamped) look.base_picture.wraps.fill(TextureWrap::clamp);
      look.base_picture.place << material.scale[0], 0, material.shift[0], 0, material.scale[1],
          material.shift[1];
      known.try_emplace(material.name, std::move(look));
    }
    std::vector<MaterialLook> looks;
    for (const std::string& name : mesh.material_names) {
      const auto found = known.find(name);
      looks.push_back(found == known.end() ? MaterialLook{} : found->second);
    }
    return looks;
  }

  /// Faces from here on belong to "o", "g" or "o/g", by what the file has said.
  void begin_object() {
    is_new_object_ = false;
    const std::string name =
        object_.empty() || group_.empty() ? object_ + group_ : object_ + "/" + group_;
    if (name.empty()) {
      object_index_ = -1;
      return;
    }
    if (object_names_.empty()) soup_.objects.assign(soup_.ends.size(), -1);
    const auto [found, is_new] =
        object_indices_.try_emplace(name, static_cast<std::int32_t>(object_names_.size()));
    if (is_new) {
      object_names_.push_back(name);
      scene_.objects.emplace_back(object_, group_);
    }
    object_index_ = found->second;
  }

  const MeshSource& source_;
  TextCursor text_;
  PolygonSoup soup_;
  std::vector<Color> colors_;
  std::vector<std::string> material_names_;
  std::unordered_map<std::string, std::int32_t> material_indices_;
  std::int32_t material_ = -1;
  std::string object_, group_;  ///< as the last `o` and `g` said
  bool is_new_object_ = false;  ///< no face has come since
  std::vector<std::string> object_names_;
  std::unordered_map<std::string, std::int32_t> object_indices_;
  std::int32_t object_index_ = -1;
  ObjScene scene_;
  std::map<std::string, std::size_t> left_out_;  ///< lines by keyword
};

}  // namespace

SurfaceMesh read_obj(const MeshSource& source) {
  return ObjReader(source).read();
}

}  // namespace craze
