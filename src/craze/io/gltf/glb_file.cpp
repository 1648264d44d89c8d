// Format: Khronos Group, "glTF 2.0 Specification", 2021, section 4.
#include "craze/io/gltf/glb_file.h"

#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "craze/error.h"
#include "craze/io/bytes/byte_order.h"

namespace craze {

void write_glb_file(std::string json, std::span<const std::string> bin, ByteSink& sink) {
  std::size_t used = 0;
  for (const std::string& part : bin) used += part.size();
  if (json.size() + used > std::numeric_limits<std::uint32_t>::max() - (1u << 24)) {
    throw Error(ErrorKind::request, "cannot write mesh", "GLB", "it would take more than 4 GB");
  }
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t bin_size = (used + 3) / 4 * 4;
  const std::size_t size = 20 + json.size() + (used == 0 ? 0 : 8 + bin_size);
  std::string& file = sink.pending();
  file += "glTF";
  append(file, std::uint32_t{2});
  append(file, static_cast<std::uint32_t>(size));
  append(file, static_cast<std::uint32_t>(json.size()));
  file += "JSON";
  sink.put(json);
  if (used == 0) return;
  append(file, static_cast<std::uint32_t>(bin_size));
  file.append("BIN\0", 4);
  for (const std::string& part : bin) sink.put(part);
  file.append(bin_size - used, '\0');
}

std::string glb_file(std::string json, const std::string& bin) {
  std::string file;
  file.reserve(json.size() + bin.size() + 32);
  ByteSink sink([&](std::string_view bytes) { file += bytes; });
  write_glb_file(std::move(json), {&bin, 1}, sink);
  sink.flush();
  return file;
}

}  // namespace craze
