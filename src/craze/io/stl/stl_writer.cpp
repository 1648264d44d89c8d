#include <fmt/format.h>

#include "craze/base/progress_meter.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/polygons/face_normal.h"
#include "craze/io/polygons/single_precision.h"
#include "craze/io/stl/stl.h"

namespace craze {

std::string format_stl(const SurfaceMesh& mesh, const MeshFileOptions& options,
                       const Context& context) {
  ProgressMeter meter(context, "write", mesh.triangles.size());
  std::string bytes(80, '\0');
  const std::string_view title = "binary STL by craze";  // must not start with "solid"
  bytes.replace(0, title.size(), title);
  bytes.reserve(84 + 50 * mesh.triangles.size());
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    meter.at(f);
    for (const float x : to_floats(face_normal(mesh, f), "STL")) append(bytes, x);
    for (const std::int32_t v : mesh.triangles[f]) {
      for (const float x : to_floats(mesh.positions[v], "STL")) append(bytes, x);
    }
    append(bytes, std::uint16_t{0});
  }
  if (options.warn) {
    if (const std::string loss = describe_precision_loss(mesh); !loss.empty()) {
      options.warn("STL holds single precision alone: " + loss);
    }
  }
  return bytes;
}

}  // namespace craze
