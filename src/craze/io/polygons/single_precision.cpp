#include "craze/io/polygons/single_precision.h"

#include <algorithm>
#include <limits>
#include <string>

#include "craze/base/text/format.h"
#include "craze/error.h"

namespace craze {

std::array<float, 3> to_floats(const Vec3& p, const char* format) {
  // Compared in double: converting a larger number to float is undefined.
  if (!(p.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max())) {
    throw Error(ErrorKind::request, "cannot write mesh", format,
                "a coordinate is too large for this format's single precision");
  }
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

std::string describe_precision_loss(const SurfaceMesh& mesh) {
  constexpr double noticed = 1e-6;
  if (mesh.positions.empty()) return "";
  Vec3 low = mesh.positions[0], high = low;
  double loss = 0;
  const auto rounded = [&](std::int32_t v) {
    return Vec3(mesh.positions[v].cast<float>().cast<double>());
  };
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    loss = std::max(loss, (rounded(static_cast<std::int32_t>(v)) - p).norm());
  }
  const double size = (high - low).norm();
  if (!(loss > noticed * size)) return "";
  const auto double_area = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b - a).cross(c - a).norm();
  };
  std::size_t vanished = 0;
  for (const Triangle& t : mesh.triangles) {
    const double before =
        double_area(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
    if (before > 0 && double_area(rounded(t[0]), rounded(t[1]), rounded(t[2])) == 0) ++vanished;
  }
  return fmt::format(
      "vertices move by up to {:.2g}, {:.2g} of the mesh's size, and {} of {} triangles lose their "
      "area; move the mesh to the origin before",
      loss, loss / size, vanished, mesh.triangles.size());
}

}  // namespace craze
