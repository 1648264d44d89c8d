#include "craze/io/lines/write_lines.h"

#include <fmt/compile.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "craze/base/text/format.h"
#include "craze/error.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/files/atomic_file.h"
#include "craze/io/files/extension.h"
#include "craze/io/ply/ply_properties.h"

namespace craze {

namespace {

using nlohmann::ordered_json;

ordered_json to_json(const std::vector<Attribute>& attributes) {
  ordered_json object = ordered_json::object();
  for (const Attribute& a : attributes) {
    ordered_json rows = a.values;
    if (a.components != 1) {
      rows = ordered_json::array();
      for (auto row = a.values.begin(); row != a.values.end(); row += a.components) {
        rows.push_back(std::vector<double>(row, row + a.components));
      }
    }
    object[a.name] = std::move(rows);
  }
  return object;
}

using Formatter = std::string (*)(const LineSet&, const LinesWarning&);

/// Of formats that hold everything, or nothing besides the lines.
template <std::string (*format)(const LineSet&)>
std::string whole(const LineSet& lines, const LinesWarning&) {
  return format(lines);
}

constexpr const char* what = "cannot write lines";

/// `where`: the file or the format, for messages.
Formatter formatter_of(std::string_view format, const std::string& where) {
  if (format == "ply") return whole<format_lines_ply>;
  if (format == "obj") return whole<format_lines_obj>;
  if (format == "svg") return format_lines_svg;
  if (format == "json") return whole<format_lines_json>;
  throw Error(ErrorKind::usage, what, where, "the extension must be .ply, .obj, .svg or .json");
}

}  // namespace

std::string format_lines_ply(const LineSet& lines) {
  PlyProperties point;
  for (int k = 0; k < 3; ++k) {
    point.add_double(std::string(1, "xyz"[k]),
                     [&lines, k](std::size_t i) { return lines.points[i][k]; });
  }
  for (const Attribute& a : lines.point_attributes) point.add_attribute(a);
  PlyProperties edge;
  for (std::size_t end = 0; end < 2; ++end) {
    edge.add(
        fmt::format("vertex{}", end + 1), "int",
        [&lines, end](std::string& bytes, std::size_t e) { append(bytes, lines.edges[e][end]); });
  }
  for (std::size_t i = 0; i < 4 && !lines.uvs.empty(); ++i) {
    edge.add_double(fmt::format("{}{}", "st"[i % 2], i / 2 + 1), [&lines, i](std::size_t e) {
      return lines.uvs[2 * e + i / 2][static_cast<Eigen::Index>(i % 2)];
    });
  }
  for (const Attribute& a : lines.edge_attributes) edge.add_attribute(a);

  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment craze\nelement vertex {}\n{}element edge "
      "{}\n{}end_header\n",
      lines.points.size(), point.header(), lines.edges.size(), edge.header());
  for (std::size_t i = 0; i < lines.points.size(); ++i) point.append_row(bytes, i);
  for (std::size_t e = 0; e < lines.edges.size(); ++e) edge.append_row(bytes, e);
  return bytes;
}

std::string format_lines_obj(const LineSet& lines) {
  std::string text = "# craze\n";
  const auto out = std::back_inserter(text);
  for (const Vec3& p : lines.points) {
    fmt::format_to(out, FMT_COMPILE("v {} {} {}\n"), p.x(), p.y(), p.z());
  }
  for (const auto& chain : join_edges(lines)) {
    text += 'l';
    for (const std::int32_t p : chain) fmt::format_to(out, FMT_COMPILE(" {}"), p + 1);
    text += '\n';
  }
  return text;
}

std::string format_lines_json(const LineSet& lines) {
  ordered_json root;
  root["points"] = ordered_json::array();
  for (const Vec3& p : lines.points) root["points"].push_back({p.x(), p.y(), p.z()});
  root["edges"] = lines.edges;
  for (std::size_t i = 0; i + 1 < lines.uvs.size(); i += 2) {
    const Vec2 &a = lines.uvs[i], &b = lines.uvs[i + 1];
    root["uvs"].push_back({{a.x(), a.y()}, {b.x(), b.y()}});
  }
  if (!lines.point_attributes.empty()) {
    root["point_attributes"] = to_json(lines.point_attributes);
  }
  if (!lines.edge_attributes.empty()) root["edge_attributes"] = to_json(lines.edge_attributes);
  return root.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string format_lines(const LineSet& lines, std::string_view format, const LinesWarning& warn) {
  return formatter_of(format, std::string(format))(lines, warn);
}

void write_lines(const std::filesystem::path& path, const LineSet& lines, const LinesWarning& warn,
                 const Context& context) {
  const std::string extension = lower_extension(path);
  const Formatter format =
      formatter_of(extension.empty() ? "" : extension.substr(1), path.string());
  write_file(path, format(lines, warn), what, context);
}

}  // namespace craze
