#include "craze/io/byte_order.h"
#include "craze/io/single_precision.h"
#include "craze/io/stl.h"

namespace craze {

std::string format_stl(const SurfaceMesh& mesh) {
  std::string bytes(80, '\0');
  const std::string_view title = "binary STL by craze";  // must not start with "solid"
  bytes.replace(0, title.size(), title);
  bytes.reserve(84 + 50 * mesh.triangles.size());
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Vec3 normal = (b - a).cross(c - a).stableNormalized();  // zero stays zero
    for (const Vec3& v : {normal, a, b, c}) {
      for (const float x : to_floats(v, "STL")) append(bytes, x);
    }
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace craze
