// What the readers of lines owe to any bytes: lines whose indices are in range, or an Error(input).
#include <cmath>
#include <string>

#include "craze/error.h"
#include "craze/io/lines/read_lines.h"
#include "fuzz_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace craze;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const char* name : {"fuzz.obj", "fuzz.ply", "fuzz.json"}) {
    try {
      const auto lines = read_lines(bytes, name);
      if (!lines) continue;
      const auto points = static_cast<std::int32_t>(lines->points.size());
      for (const Vec3& p : lines->points) require(p.allFinite());
      for (const auto& e : lines->edges) {
        for (const std::int32_t p : e) require(p >= 0 && p < points);
      }
    } catch (const Error& e) {
      require(e.kind() == ErrorKind::input);
      require(std::string_view(e.what()).find('\n') == std::string_view::npos);
    }
  }
  return 0;
}
