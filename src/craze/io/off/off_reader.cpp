// Format: The Geometry Center, Geomview manual, section "OFF: (4)(n)OFF".

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/bytes/text_cursor.h"
#include "craze/io/off/off.h"
#include "craze/io/polygons/polygon_soup.h"

namespace craze {

namespace {

/// Bytes between two looks at the clock.
constexpr std::size_t meter_step = std::size_t{1} << 20;

using RawColor = std::array<double, 4>;

struct OffKind {
  bool uvs = false, colors = false, normals = false;
};

OffKind read_kind(TextCursor& text) {
  OffKind kind;
  text.skip_blank();
  const TextCursor start = text;
  const std::string_view keyword = text.word();
  if (!keyword.empty() && keyword.find_first_not_of("0123456789") == std::string_view::npos) {
    text = start;  // the keyword is optional
    return kind;
  }
  std::string_view rest = keyword;
  const auto accept = [&](std::string_view prefix) {
    if (!rest.starts_with(prefix)) return false;
    rest.remove_prefix(prefix.size());
    return true;
  };
  kind.uvs = accept("ST");
  kind.colors = accept("C");
  kind.normals = accept("N");
  if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF") {
    text.fail(fmt::format("'{}' is not three-dimensional", printable(keyword)));
  }
  if (rest != "OFF") text.fail("it does not start with 'OFF'");
  TextCursor ahead = text;
  if (ahead.more_on_line() && ahead.word() == "BINARY") text.fail("binary OFF is not supported");
  return kind;
}

/// A count, with at least `bytes_each` bytes of the file for each.
std::size_t read_count(TextCursor& text, const char* what, std::size_t bytes_each) {
  if (!text.skip_blank()) text.fail(fmt::format("{} is missing", what));
  const std::int64_t count = text.integer(what);
  if (count < 0) text.fail(fmt::format("{} is negative", what));
  if (static_cast<std::size_t>(count) > text.remaining() / bytes_each + 1) {
    text.fail(fmt::format("{} {} is more than the file can hold", what, count));
  }
  return static_cast<std::size_t>(count);
}

/// 0 … 1, or 0 … 255 where one of them exceeds 1.
double color_scale(const std::vector<RawColor>& raw) {
  double largest = 0;
  for (const RawColor& c : raw) largest = std::max({largest, c[0], c[1], c[2]});
  return largest > 1 ? 255 : 1;
}

std::vector<Color> to_colors(const std::vector<RawColor>& raw) {
  const double scale = color_scale(raw);
  std::vector<Color> colors;
  colors.reserve(raw.size());
  for (const RawColor& c : raw) {
    Color& color = colors.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      // An alpha of 1 is opaque in either scale.
      const double unit = i == 3 && c[3] <= 1 ? c[3] : c[i] / scale;
      color[i] = static_cast<float>(std::clamp(unit, 0.0, 1.0));
    }
  }
  return colors;
}

/// Numbers are tokens, wherever lines end. Only what may be missing, colours and their alpha, is
/// sought on the rest of the line, and only where every vertex and face has a line of its own.
class OffReader {
 public:
  explicit OffReader(const MeshSource& source)
      : source_(source),
        text_(source.bytes, source.name),
        meter_(source.context, "load", source.bytes.size(), meter_step) {}

  SurfaceMesh read() {
    kind_ = read_kind(text_);
    vertices_ = read_count(text_, "the number of vertices", 6);
    const std::size_t line = text_.line();
    faces_ = read_count(text_, "the number of faces", 2);
    // The number of edges means nothing and may be missing, but not where each has a line.
    if (text_.more_on_line() || (text_.line() != line && text_.skip_blank())) {
      text_.number("the number of edges");
    }
    body_ = text_;
    read_vertices();
    read_faces();
    SurfaceMesh mesh = triangulate(std::move(soup_), source_);
    if (kind_.colors) mesh.vertex_colors = to_colors(vertex_colors_);
    add_face_colors(mesh);
    warn();
    return mesh;
  }

 private:
  double next(const char* what) {
    text_.skip_blank();
    return text_.number(what);
  }

  /// `instead` for a number that is not finite.
  double next_mended(const char* what, double instead) {
    text_.skip_blank();
    const double value = text_.any_number(what);
    if (std::isfinite(value)) return value;
    ++mended_;
    return instead;
  }

  bool has_line_per_row() {
    if (!line_per_row_) line_per_row_ = rows_fit_lines();
    return *line_per_row_;
  }

  /// Whether each vertex and face has a line with all the numbers that it needs.
  bool rows_fit_lines() const {
    TextCursor lines = body_;
    const std::size_t of_vertex =
        std::size_t{3} + (kind_.normals ? 3 : 0) + (kind_.colors ? 3 : 0) + (kind_.uvs ? 2 : 0);
    for (std::size_t v = 0; v < vertices_; ++v) {
      if (!lines.skip_blank() || words_to_line_end(lines, of_vertex) < of_vertex) return false;
      lines.skip_line();
    }
    for (std::size_t f = 0; f < faces_; ++f) {
      if (!lines.skip_blank()) return false;
      const std::string_view word = lines.word();
      std::size_t corners = 0;
      const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), corners);
      if (status != std::errc{} || end != word.data() + word.size()) return false;
      if (words_to_line_end(lines, corners) < corners) return false;
      lines.skip_line();
    }
    return true;
  }

  /// At most `enough`.
  static std::size_t words_to_line_end(TextCursor& text, std::size_t enough) {
    std::size_t count = 0;
    for (; count < enough && text.more_on_line(); ++count) text.word();
    return count;
  }

  /// Numbers on the rest of the line, at most four; what follows them is skipped too.
  std::size_t rest_of_row(RawColor& numbers) {
    if (!text_.more_on_line() || !has_line_per_row()) return 0;
    std::size_t count = 0;
    while (count < 4 && text_.more_on_line()) numbers[count++] = next_mended("a colour", 1);
    text_.skip_line();
    return count;
  }

  void read_vertices() {
    const char* what = "a vertex's number";
    soup_.positions.reserve(vertices_);
    for (std::size_t v = 0; v < vertices_; ++v) {
      meter_.at(text_.offset());
      if (!text_.skip_blank()) {
        text_.fail(fmt::format("the file ends after {} of {} vertices", v, vertices_));
      }
      const double x = next(what), y = next(what);
      soup_.positions.emplace_back(x, y, next(what));
      if (kind_.normals) {
        const double nx = next_mended(what, 0), ny = next_mended(what, 0);
        soup_.normals.emplace_back(nx, ny, next_mended(what, 0));
      }
      if (kind_.colors) read_vertex_color();
      if (kind_.uvs) {
        const double s = next_mended(what, 0);
        soup_.uvs.emplace_back(s, next_mended(what, 0));
      }
      if (text_.more_on_line() && has_line_per_row()) {
        ++longer_vertices_;
        text_.skip_line();
      }
    }
  }

  void read_vertex_color() {
    const char* what = "a vertex's colour";
    const double r = next_mended(what, 1), g = next_mended(what, 1), b = next_mended(what, 1);
    // A UV's two numbers may follow; alpha is there only if something stands before them.
    TextCursor ahead = text_;
    int left = 0;
    while (ahead.more_on_line() && left < 3) {
      ahead.word();
      ++left;
    }
    const bool has_alpha = left > (kind_.uvs ? 2 : 0) && has_line_per_row();
    vertex_colors_.push_back({r, g, b, has_alpha ? next_mended(what, 1) : 1.0});
  }

  void read_faces() {
    for (std::size_t f = 0; f < faces_; ++f) {
      meter_.at(text_.offset());
      if (!text_.skip_blank()) {
        text_.fail(fmt::format("the file ends after {} of {} faces", f, faces_));
      }
      const std::int64_t corners = text_.integer("a face's number of corners");
      if (corners < 0) text_.fail("a face's number of corners is negative");
      for (std::int64_t i = 0; i < corners; ++i) {
        text_.skip_blank();
        const std::int64_t v = text_.integer("a face's index");
        if (v < 0 || static_cast<std::size_t>(v) >= vertices_) {
          text_.fail(fmt::format("a face asks for vertex {} of {}", v, vertices_));
        }
        const auto index = static_cast<std::int32_t>(v);
        soup_.corners.push_back({index, kind_.uvs ? index : -1, kind_.normals ? index : -1});
      }
      soup_.close_polygon();
      RawColor color{0, 0, 0, 1};
      const std::size_t numbers = rest_of_row(color);
      if (numbers >= 3 && face_colors_.empty()) {
        face_colors_.resize(f, RawColor{-1, -1, -1, 1});  // none
      }
      if (numbers == 1) ++color_map_faces_;
      if (!face_colors_.empty() || numbers >= 3) {
        face_colors_.push_back(numbers >= 3 ? color : RawColor{-1, -1, -1, 1});
      }
    }
  }

  /// As face attributes red, green and blue, 0 … 255, and alpha where not all are opaque; a face
  /// without a colour is white.
  void add_face_colors(SurfaceMesh& mesh) const {
    if (face_colors_.empty()) return;
    const double scale = 255 / color_scale(face_colors_);
    const char* names[] = {"red", "green", "blue", "alpha"};
    const auto value_of = [&](const RawColor& color, std::size_t c) {
      if (color[0] < 0) return 255.0;
      // An alpha of 1 is opaque in either scale.
      const double value = c == 3 && color[c] <= 1 ? 255 * color[c] : color[c] * scale;
      return std::clamp(std::round(value), 0.0, 255.0);
    };
    for (std::size_t c = 0; c < 4; ++c) {
      Attribute channel{names[c], 1, {}};
      channel.values.reserve(mesh.source_faces.size());
      bool any = c < 3;
      for (const std::int32_t f : mesh.source_faces) {
        channel.values.push_back(value_of(face_colors_[static_cast<std::size_t>(f)], c));
        any = any || channel.values.back() != 255;
      }
      if (any) mesh.face_attributes.push_back(std::move(channel));
    }
  }

  void warn() {
    if (text_.skip_blank()) {
      source_.warn(fmt::format("{} bytes after the last face are not read", text_.remaining()));
    }
    if (mended_ > 0) {
      source_.warn(fmt::format(
          "{} numbers of normals, texture coordinates or colours are not finite; they are mended",
          mended_));
    }
    if (color_map_faces_ > 0) {
      source_.warn(
          fmt::format("{} faces name a colour of a map that is not in the file; they are "
                      "left without",
                      color_map_faces_));
    }
    if (longer_vertices_ > 0) {
      source_.warn(
          fmt::format("{} vertices have more numbers than the file's first word says; "
                      "these are not read",
                      longer_vertices_));
    }
  }

  const MeshSource& source_;
  TextCursor text_, body_ = text_;
  ProgressMeter meter_;
  OffKind kind_;
  std::size_t vertices_ = 0, faces_ = 0;
  std::optional<bool> line_per_row_;  ///< once it matters
  PolygonSoup soup_;
  std::vector<RawColor> vertex_colors_, face_colors_;
  std::size_t color_map_faces_ = 0, longer_vertices_ = 0, mended_ = 0;
};

}  // namespace

bool is_off(std::string_view bytes) {
  const std::string none;
  TextCursor text(bytes.substr(0, 1000), none);
  if (!text.skip_blank()) return false;
  std::string_view word = text.word();
  for (const std::string_view prefix : {"ST", "C", "N", "4", "n"}) {
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  }
  return word == "OFF";
}

SurfaceMesh read_off(const MeshSource& source) {
  return OffReader(source).read();
}

}  // namespace craze
