// Format: G. Turk, "The PLY Polygon File Format", Stanford University, 1994.
#include "craze/io/ply/ply_header.h"

#include <set>

#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/bytes/text_cursor.h"

namespace craze {

namespace {

/// Far above what files have; more would only serve to make rows slow.
constexpr std::size_t max_properties = 1024;

PlyType parse_type(TextCursor& text) {
  if (!text.more_on_line()) text.fail("a property's type is missing");
  const std::string_view w = text.word();
  if (w == "char" || w == "int8") return PlyType::int8;
  if (w == "uchar" || w == "uint8") return PlyType::uint8;
  if (w == "short" || w == "int16") return PlyType::int16;
  if (w == "ushort" || w == "uint16") return PlyType::uint16;
  if (w == "int" || w == "int32") return PlyType::int32;
  if (w == "uint" || w == "uint32") return PlyType::uint32;
  if (w == "int64") return PlyType::int64;
  if (w == "uint64") return PlyType::uint64;
  if (w == "float" || w == "float32") return PlyType::float32;
  if (w == "double" || w == "float64") return PlyType::float64;
  text.fail(fmt::format("'{}' is not a property type", printable(w)));
}

PlyFormat parse_format(TextCursor& text) {
  text.more_on_line();
  const std::string_view w = text.word();
  if (w == "ascii") return PlyFormat::ascii;
  if (w == "binary_little_endian") return PlyFormat::binary_little_endian;
  if (w == "binary_big_endian") return PlyFormat::binary_big_endian;
  text.fail(fmt::format("'{}' is not a PLY format", printable(w)));
}

std::string parse_name(TextCursor& text, const char* what) {
  if (!text.more_on_line()) text.fail(fmt::format("{}'s name is missing", what));
  return std::string(text.word());
}

PlyProperty parse_property(TextCursor& text) {
  PlyProperty property;
  text.more_on_line();
  TextCursor before = text;
  if (text.word() == "list") {
    property.is_list = true;
    property.count_type = parse_type(text);
    if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64) {
      text.fail("a list's length cannot be a float");
    }
  } else {
    text = before;
  }
  property.type = parse_type(text);
  property.name = parse_name(text, "a property");
  return property;
}

PlyElement parse_element(TextCursor& text) {
  PlyElement element;
  element.name = parse_name(text, "an element");
  const std::int64_t count = text.integer("an element's count");
  if (count < 0) text.fail("an element's count is negative");
  element.count = static_cast<std::size_t>(count);
  return element;
}

void check_names(const PlyElement& element, const TextCursor& text) {
  std::set<std::string> names;
  for (const PlyProperty& property : element.properties) {
    if (names.insert(property.name).second) continue;
    text.fail(fmt::format("'{}' has the property '{}' twice", printable(element.name),
                          printable(property.name)));
  }
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::int64:
    case PlyType::uint64:
    case PlyType::float64:
      return 8;
  }
  return 0;
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) {
  TextCursor text(bytes, name);
  if (text.word() != "ply") text.fail("it does not start with 'ply'");
  PlyHeader header;
  bool has_format = false;
  for (;;) {
    text.skip_line();
    if (!text.skip_blank()) text.fail("the header has no end_header");
    const std::string_view keyword = text.word();
    if (keyword == "end_header") break;
    if (keyword == "format") {
      header.format = parse_format(text);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(parse_element(text));
      if (header.elements.size() > max_properties) text.fail("there are too many elements");
    } else if (keyword == "property") {
      if (header.elements.empty()) text.fail("a property stands before the first element");
      auto& properties = header.elements.back().properties;
      properties.push_back(parse_property(text));
      if (properties.size() > max_properties) text.fail("an element has too many properties");
    } else if (keyword == "comment") {
      text.more_on_line();
      const std::string_view what = text.word();
      const std::string rest(text.rest_of_line());
      if (what == "material") {
        header.materials.push_back(rest);
        continue;
      }
      if (what == "TextureFile") header.textures.push_back(rest);
      const std::string comment = std::string(what) + (rest.empty() ? "" : " " + rest);
      if (comment != "craze") header.comments.push_back(comment);
    } else if (keyword == "obj_info") {
      text.more_on_line();
      header.infos.emplace_back(text.rest_of_line());
    } else {
      text.fail(fmt::format("'{}' is not a PLY header line", printable(keyword)));
    }
  }
  if (!has_format) text.fail("the header has no format line");
  for (const PlyElement& element : header.elements) check_names(element, text);
  text.skip_line();
  header.size = text.offset();
  // Where lines end with \r alone, a \n that follows the header is the first byte of its rows.
  const bool lone_returns = bytes.starts_with("ply\r") && !bytes.starts_with("ply\r\n");
  if (lone_returns && bytes[header.size - 1] == '\n') --header.size;
  header.lines = text.line() - 1;
  return header;
}

}  // namespace craze
