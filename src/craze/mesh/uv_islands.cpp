#include "craze/mesh/uv_islands.h"

#include <algorithm>
#include <cmath>

#include "craze/mesh/remesh/feature_lines.h"

namespace craze {

namespace {

double doubled_uv_area(const SurfaceMesh& surface, std::size_t f) {
  const Vec2* uv = &surface.corner_uvs[3 * f];
  const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
  return std::abs(a.x() * b.y() - a.y() * b.x());
}

}  // namespace

std::vector<std::int32_t> uv_islands(const SurfaceMesh& surface) {
  SurfaceMesh uvs_alone;  // materials part no islands
  uvs_alone.corner_uvs = surface.corner_uvs;
  const TriangleMesh mesh(surface.positions, surface.triangles);
  const std::vector<char> marks = feature_lines(uvs_alone, mesh, 180);
  std::vector<std::int32_t> island =
      patches(mesh.face_count(), marks, seam, [&](std::int32_t h) { return mesh.opposite(h); });
  std::vector<char> has_area(surface.triangles.size(), 0);  // by island
  for (std::size_t f = 0; f < island.size(); ++f) {
    if (doubled_uv_area(surface, f) > 0) has_area[island[f]] = 1;
  }
  std::vector<std::int32_t> number(island.size(), -1);
  std::int32_t count = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (has_area[i]) number[i] = count++;
  }
  std::transform(island.begin(), island.end(), island.begin(),
                 [&](std::int32_t i) { return number[i]; });
  return island;
}

}  // namespace craze
