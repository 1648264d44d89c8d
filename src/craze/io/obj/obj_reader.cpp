// Format: Wavefront Technologies, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/bytes/text_cursor.h"
#include "craze/io/obj/obj.h"
#include "craze/io/obj/obj_materials.h"
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
        bring_library(std::string(text_.rest_of_line()), source_, scene_);
      } else if (keyword == "o") {
        object_ = text_.rest_of_line();
        group_.clear();
        is_new_object_ = true;
      } else if (keyword == "g") {
        group_ = text_.rest_of_line();
        is_new_object_ = true;
      } else if (keyword == "s") {
        smoothing_ = text_.rest_of_line();
      } else if (!keyword.empty()) {
        leave_out(keyword);
      }
      text_.skip_line();
    }
    // Where all edges are smooth, or normals say which are, nothing is left to be said.
    const bool has_hard =
        smoothings_.size() > 1 || smoothings_.count("off") || smoothings_.count("0");
    if (has_hard && soup_.normals.empty()) {
      source_.warn(
          "smoothing groups ('s') are not kept; a mesh without normals is shaded by its angles");
    }
    SurfaceMesh mesh = triangulate(std::move(soup_), source_);
    warn_of_left_out();
    warn_of_numbers();
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
      n[count] = count < 3 ? text_.number("a coordinate") : text_.any_number("a colour");
      ++count;
    }
    soup_.positions.emplace_back(n[0], n[1], n[2]);
    // The weight w is for curves; what follows it can be no colour.
    left_over_ += count == 5 || (count == 4 && n[3] != 1) || text_.more_on_line();
    if (count < 6) return;
    colors_.resize(soup_.positions.size() - 1, Color{1, 1, 1, 1});
    Color& color = colors_.emplace_back(Color{1, 1, 1, 1});
    const auto channels = static_cast<std::size_t>(count - 3);
    if (!std::all_of(n + 3, n + count, [](double c) { return std::isfinite(c); })) {
      ++broken_colors_;
      return;
    }
    for (std::size_t k = 0; k < channels; ++k) {
      const double inside = std::clamp(n[3 + k], 0.0, 1.0);
      color[k] = static_cast<float>(inside);
    }
    const auto is_outside = [](double c) { return c < 0 || c > 1; };
    bounded_colors_ += std::any_of(n + 3, n + count, is_outside);
  }

  void read_uv() {
    const char* what = "a texture coordinate";
    Vec2 uv(text_.any_number(what), 0);
    if (text_.more_on_line()) uv.y() = text_.any_number(what);
    if (text_.more_on_line()) left_over_uvs_ += text_.any_number(what) != 0;
    if (!uv.allFinite()) {
      ++broken_uvs_;
      uv.setZero();
    }
    soup_.uvs.push_back(uv);
  }

  void read_normal() {
    const char* what = "a normal";
    Vec3 normal;
    for (double& x : normal) x = text_.any_number(what);
    if (!normal.allFinite()) {
      ++broken_normals_;
      normal.setZero();
    }
    soup_.normals.push_back(normal);
  }

  void warn_of_numbers() const {
    const auto tell = [&](std::size_t count, const char* sentence) {
      if (count > 0) source_.warn(fmt::format("{} {}", count, sentence));
    };
    tell(broken_uvs_, "texture coordinates are not finite numbers; they are 0");
    tell(broken_normals_, "normals are not finite numbers; their faces' stand in");
    tell(broken_colors_, "colours are not finite numbers; they are white");
    tell(bounded_colors_, "colours go beyond 0 to 1; they are bounded to it");
    tell(left_over_, "vertices have weights or further numbers, which are not kept");
    tell(left_over_uvs_, "texture coordinates have a third number, which is not kept");
  }

  /// Corners V, V/VT, V//VN or V/VT/VN; what is behind a slash may be missing.
  void read_face() {
    if (is_new_object_) begin_object();
    if (!smoothing_.empty() && smoothings_.size() < 2) smoothings_.insert(smoothing_);
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

  /// Keeps what the file says besides its surface, and the pictures of its materials.
  void keep_scene(const SurfaceMesh& mesh) {
    if (scene_.libraries.empty() && scene_.objects.empty()) return;
    scene_.folder = std::filesystem::path(source_.name).parent_path();
    bring_pictures(mesh.material_names, source_, scene_);
    source_.scene = std::make_shared<const ObjScene>(std::move(scene_));
  }

  /// Faces from here on belong to "o", "g" or "o/g", by what the file has said.
  void begin_object() {
    is_new_object_ = false;
    const std::string name = object_name(object_, group_);
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
  std::string smoothing_;             ///< as the last `s` said; "": none has
  std::set<std::string> smoothings_;  ///< of faces, two at most
  ObjScene scene_;
  std::size_t broken_uvs_ = 0, broken_normals_ = 0, broken_colors_ = 0, bounded_colors_ = 0;
  std::size_t left_over_ = 0, left_over_uvs_ = 0;
  std::map<std::string, std::size_t> left_out_;  ///< lines by keyword
};

}  // namespace

SurfaceMesh read_obj(const MeshSource& source) {
  return ObjReader(source).read();
}

}  // namespace craze
