// Format: The Geometry Center, Geomview manual, section "OFF: (4)(n)OFF".
#include <fmt/format.h>

#include <algorithm>

#include "craze/io/bytes/input_error.h"
#include "craze/io/bytes/text_cursor.h"
#include "craze/io/off/off.h"
#include "craze/io/polygons/polygon_soup.h"

namespace craze {

namespace {

struct OffKind {
  bool uvs = false, colors = false, normals = false;
};

OffKind read_kind(TextCursor& text) {
  OffKind kind;
  text.skip_blank();
  const std::string_view keyword = text.word();
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

std::vector<Color> to_colors(const std::vector<std::array<double, 4>>& raw) {
  double largest = 0;
  for (const auto& c : raw) largest = std::max({largest, c[0], c[1], c[2]});
  const double scale = largest > 1 ? 255 : 1;
  std::vector<Color> colors;
  colors.reserve(raw.size());
  for (const auto& c : raw) {
    Color& color = colors.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      // An alpha of 1 is opaque in either scale.
      const double unit = i == 3 && c[3] <= 1 ? c[3] : c[i] / scale;
      color[i] = static_cast<float>(std::clamp(unit, 0.0, 1.0));
    }
  }
  return colors;
}

}  // namespace

SurfaceMesh read_off(std::string_view bytes, const std::string& name) {
  TextCursor text(bytes, name);
  const OffKind kind = read_kind(text);
  const std::size_t vertices = read_count(text, "the number of vertices", 6);
  const std::size_t faces = read_count(text, "the number of faces", 2);
  text.skip_line();  // the number of edges means nothing

  PolygonSoup soup;
  std::vector<std::array<double, 4>> colors;
  soup.positions.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!text.skip_blank()) {
      text.fail(fmt::format("the file ends after {} of {} vertices", v, vertices));
    }
    const auto next = [&] { return text.number("a vertex's number"); };
    const double x = next(), y = next();
    soup.positions.emplace_back(x, y, next());
    if (kind.normals) {
      const double nx = next(), ny = next();
      soup.normals.emplace_back(nx, ny, next());
    }
    if (kind.colors) {
      const double r = next(), g = next(), b = next();
      // A UV's two numbers may follow; alpha is there only if something stands before them.
      TextCursor ahead = text;
      int left = 0;
      while (ahead.more_on_line() && left < 3) {
        ahead.word();
        ++left;
      }
      colors.push_back({r, g, b, left > (kind.uvs ? 2 : 0) ? next() : 1.0});
    }
    if (kind.uvs) {
      const double s = next();
      soup.uvs.emplace_back(s, next());
    }
    text.skip_line();
  }
  for (std::size_t f = 0; f < faces; ++f) {
    if (!text.skip_blank()) {
      text.fail(fmt::format("the file ends after {} of {} faces", f, faces));
    }
    const std::int64_t corners = text.integer("a face's number of corners");
    if (corners < 0) text.fail("a face's number of corners is negative");
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::int64_t v = text.integer("a face's index");
      if (v < 0 || static_cast<std::size_t>(v) >= vertices) {
        text.fail(fmt::format("a face asks for vertex {} of {}", v, vertices));
      }
      const auto index = static_cast<std::int32_t>(v);
      soup.corners.push_back({index, kind.uvs ? index : -1, kind.normals ? index : -1});
    }
    soup.close_polygon();
    text.skip_line();
  }
  SurfaceMesh mesh = triangulate(std::move(soup), name);
  if (kind.colors) mesh.vertex_colors = to_colors(colors);
  return mesh;
}

}  // namespace craze
