// Format: Khronos Group, "glTF 2.0 Specification", 2021, section 4.
#include "craze/io/gltf/glb_file.h"

#include <cstdint>
#include <limits>

#include "craze/error.h"
#include "craze/io/bytes/byte_order.h"

namespace craze {

std::string glb_file(std::string json, const std::string& bin) {
  if (json.size() + bin.size() > std::numeric_limits<std::uint32_t>::max() - (1u << 24)) {
    throw Error(ErrorKind::request, "cannot write mesh", "GLB", "it would take more than 4 GB");
  }
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t bin_size = (bin.size() + 3) / 4 * 4;
  const std::size_t size = 20 + json.size() + (bin.empty() ? 0 : 8 + bin_size);
  std::string file;
  file.reserve(size);
  file += "glTF";
  append(file, std::uint32_t{2});
  append(file, static_cast<std::uint32_t>(size));
  append(file, static_cast<std::uint32_t>(json.size()));
  file += "JSON";
  file += json;
  if (bin.empty()) return file;
  append(file, static_cast<std::uint32_t>(bin_size));
  file.append("BIN\0", 4);
  file += bin;
  file.resize(size, '\0');
  return file;
}

}  // namespace craze
