#include "craze/io/lines/read_lines.h"

#include <algorithm>
#include <cmath>

#include "craze/base/progress_meter.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/bytes/text_cursor.h"
#include "craze/io/bytes/text_encoding.h"
#include "craze/io/files/extension.h"
#include "craze/io/files/read_file.h"
#include "craze/io/gltf/gltf_json.h"
#include "craze/io/ply/ply_table.h"

namespace craze {

namespace {

void check(const LineSet& lines, const std::string& name) {
  const auto count = static_cast<std::int32_t>(lines.points.size());
  for (std::size_t e = 0; e < lines.edges.size(); ++e) {
    for (const std::int32_t p : lines.edges[e]) {
      if (p >= 0 && p < count) continue;
      fail_input(name,
                 fmt::format("line {} refers to a point out of range, there are {}", e, count));
    }
  }
}

/// A file's number as an index; what no index can be becomes −1.
std::int32_t to_index(double x) {
  return x >= 0 && x < 2147483647.0 && x == std::floor(x) ? static_cast<std::int32_t>(x) : -1;
}

LineSet parse_obj(const MeshSource& source) {
  LineSet lines;
  TextCursor text(source.bytes, source.name);
  ProgressMeter meter(source.context, "load", source.bytes.size(), std::size_t{1} << 20);
  while (text.skip_blank()) {
    meter.at(text.offset());
    const std::string_view keyword = text.word();
    if (keyword == "v") {
      const double x = text.number("a coordinate"), y = text.number("a coordinate");
      lines.points.emplace_back(x, y, text.number("a coordinate"));
    } else if (keyword == "l") {
      std::int32_t last = -1;
      while (text.more_on_line()) {  // V or V/VT
        const std::int64_t i = text.leading_integer("a line's index");
        const auto known = static_cast<std::int64_t>(lines.points.size());
        const std::int64_t index = i < 0 ? known + i : i - 1;
        if (index < 0 || index > 2147483646) text.fail("a line's index is out of range");
        text.word();
        const auto point = static_cast<std::int32_t>(index);
        if (last >= 0) lines.edges.push_back({last, point});
        last = point;
      }
    }
    text.skip_line();
  }
  return lines;
}

/// The columns of that element whose rows are single numbers, as attributes.
std::vector<Attribute> scalars(const PlyElement& element, std::vector<PlyColumn> columns,
                               const std::string& name) {
  std::vector<Attribute> result;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (element.properties[i].is_list) continue;
    for (const double x : columns[i].values) {
      if (!std::isfinite(x)) {
        fail_input(name, fmt::format("'{}' is not finite somewhere",
                                     printable(element.properties[i].name)));
      }
    }
    result.push_back({element.properties[i].name, 1, std::move(columns[i].values)});
  }
  return result;
}

/// Takes columns out of the attributes, together, or none.
std::optional<std::vector<Attribute>> take(std::vector<Attribute>& attributes,
                                           const std::vector<std::string>& names) {
  std::vector<Attribute> taken;
  for (const std::string& n : names) {
    const Attribute* found = find_attribute(attributes, n);
    if (!found) return std::nullopt;
    taken.push_back(*found);
  }
  std::erase_if(attributes, [&](const Attribute& a) {
    return std::find(names.begin(), names.end(), a.name) != names.end();
  });
  return taken;
}

LineSet parse_ply(const MeshSource& source) {
  const std::string& name = source.name;
  const PlyHeader header = parse_ply_header(source.bytes, name);
  const auto is_line = [](const PlyElement& e) { return e.name == "edge"; };
  LineSet lines;
  if (std::none_of(header.elements.begin(), header.elements.end(), is_line)) return lines;
  PlyBody body(source, header);
  for (const PlyElement& element : header.elements) {
    std::vector<PlyColumn> columns = body.read(element);
    if (element.name == "vertex") {
      lines.point_attributes = scalars(element, std::move(columns), name);
      const auto position = take(lines.point_attributes, {"x", "y", "z"});
      if (!position) fail_input(name, "its vertices have no x, y and z");
      for (std::size_t i = 0; i < element.count; ++i) {
        const auto& p = *position;
        lines.points.emplace_back(p[0].values[i], p[1].values[i], p[2].values[i]);
      }
      for (const auto& names : {std::vector<std::string>{"nx", "ny", "nz"},
                                std::vector<std::string>{"normal_0", "normal_1", "normal_2"}}) {
        const auto n = take(lines.point_attributes, names);
        if (!n) continue;
        Attribute normal{"normal", 3, {}};
        for (std::size_t i = 0; i < element.count; ++i) {
          for (int k = 0; k < 3; ++k) normal.values.push_back((*n)[k].values[i]);
        }
        lines.point_attributes.push_back(std::move(normal));
      }
    } else if (element.name == "edge") {
      lines.edge_attributes = scalars(element, std::move(columns), name);
      const auto ends = take(lines.edge_attributes, {"vertex1", "vertex2"});
      if (!ends) fail_input(name, "its edges have no vertex1 and vertex2");
      for (std::size_t i = 0; i < element.count; ++i) {
        lines.edges.push_back({to_index((*ends)[0].values[i]), to_index((*ends)[1].values[i])});
      }
    }
  }
  return lines;
}

/// A list of numbers, each finite.
std::vector<double> numbers(const Json& value, const std::string& name, const std::string& what) {
  std::vector<double> result;
  for (const Json& x : value.is_array() ? value : Json::array({value})) {
    if (!x.is_number() || !std::isfinite(x.get<double>())) {
      fail_input(name, fmt::format("'{}' holds something that is not a number", what));
    }
    result.push_back(x.get<double>());
  }
  return result;
}

std::vector<Attribute> json_attributes(const Json& root, const char* key, std::size_t count,
                                       const std::string& name) {
  std::vector<Attribute> attributes;
  if (!root.contains(key)) return attributes;
  if (!root[key].is_object()) fail_input(name, fmt::format("'{}' is not an object", key));
  for (const auto& [label, rows] : root[key].items()) {
    const std::string what = printable(label);
    if (!rows.is_array() || rows.size() != count) {
      fail_input(name, fmt::format("'{}' has not one entry per element, {}", what, count));
    }
    Attribute a{label, 1, {}};
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<double> row = numbers(rows[i], name, what);
      if (i == 0) a.components = static_cast<int>(row.size());
      if (row.empty() || row.size() != static_cast<std::size_t>(a.components)) {
        fail_input(name, fmt::format("'{}' has rows of different length", what));
      }
      a.values.insert(a.values.end(), row.begin(), row.end());
    }
    attributes.push_back(std::move(a));
  }
  return attributes;
}

LineSet parse_json_lines(const MeshSource& source) {
  const std::string& name = source.name;
  const Json root = parse_json(source.bytes, name);
  if (!root.is_object() || !root.contains("points") || !root.contains("edges")) {
    fail_input(name, "it has no 'points' and 'edges'");
  }
  const GltfJson json(name);
  LineSet lines;
  for (const Json& p : json.array(root, "points")) {
    const std::vector<double> x = numbers(p, name, "points");
    if (x.size() != 2 && x.size() != 3) fail_input(name, "a point has not 2 or 3 coordinates");
    lines.points.emplace_back(x[0], x[1], x.size() == 3 ? x[2] : 0.0);
  }
  for (const Json& e : json.array(root, "edges")) {
    const std::vector<double> ends = numbers(e, name, "edges");
    if (ends.size() != 2) fail_input(name, "an edge has not 2 ends");
    lines.edges.push_back({to_index(ends[0]), to_index(ends[1])});
  }
  lines.point_attributes = json_attributes(root, "point_attributes", lines.points.size(), name);
  lines.edge_attributes = json_attributes(root, "edge_attributes", lines.edges.size(), name);
  return lines;
}

using Reader = LineSet (*)(const MeshSource&);

/// By the extension; null where lines are not read from it.
Reader reader_of(const std::string& name) {
  const std::string extension = lower_extension(name);
  return extension == ".obj"    ? parse_obj
         : extension == ".ply"  ? parse_ply
         : extension == ".json" ? parse_json_lines
                                : nullptr;
}

}  // namespace

std::optional<LineSet> read_lines(std::string_view bytes, const std::string& name,
                                  const Context& context) {
  const Reader read = reader_of(name);
  if (!read) return std::nullopt;
  std::optional<std::string> text;
  if (has_byte_order_mark(bytes)) {
    text = decode_text(bytes, name);
    bytes = *text;
  }
  const FileLoader no_files;
  std::vector<std::string> warnings, textures;
  std::shared_ptr<const SourceScene> scene;
  LineSet lines = read({bytes, name, no_files, context, warnings, textures, scene});
  if (lines.edges.empty()) return std::nullopt;
  check(lines, name);
  return lines;
}

std::optional<LineSet> read_lines_file(const std::filesystem::path& path, const Context& context) {
  const std::string name = path.string();
  if (!reader_of(name)) return std::nullopt;
  return read_lines(read_file(path, "cannot read lines", context), name, context);
}

}  // namespace craze
