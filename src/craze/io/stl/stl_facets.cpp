#include "craze/io/stl/stl_facets.h"

#include "craze/io/bytes/byte_order.h"
#include "craze/io/bytes/input_error.h"
#include "craze/io/stl/stl.h"

namespace craze {

namespace {

bool fits_binary(std::string_view bytes) {
  return bytes.size() >= stl_header_size &&
         bytes.size() == stl_header_size + stl_record_size * load<std::uint32_t>(bytes.data() + 80);
}

/// Begins with "solid" and holds no zero byte where a binary file's count would be: text has none,
/// and a count below 2²⁴ has one.
bool is_ascii(std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos || bytes.size() - start < 5) return false;
  for (std::size_t i = 0; i < 5; ++i) {
    if ((bytes[start + i] | 0x20) != "solid"[i]) return false;
  }
  return bytes.substr(0, stl_header_size).find('\0') == std::string_view::npos;
}

}  // namespace

bool is_stl(std::string_view bytes) {
  return fits_binary(bytes) || is_ascii(bytes);
}

StlFacets read_stl_facets(const MeshSource& source) {
  if (!fits_binary(source.bytes) && is_ascii(source.bytes)) return read_ascii_stl(source);
  if (source.bytes.size() < stl_header_size) {
    fail_input(source.name, "it is neither ascii STL (no 'solid') nor long enough for binary STL");
  }
  return read_binary_stl(source);
}

}  // namespace craze
