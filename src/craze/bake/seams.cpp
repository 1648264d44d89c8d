#include "craze/bake/seams.h"

#include <algorithm>
#include <array>

namespace craze {

namespace {

using Ends = std::array<double, 6>;

Ends ends(const Vec3& a, const Vec3& b) {
  return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
}

}  // namespace

std::vector<std::int32_t> seam_sides(const TriangleMesh& mesh) {
  std::vector<std::int32_t> borders;
  std::vector<Ends> known;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) != TriangleMesh::border) continue;
    borders.push_back(h);
    known.push_back(ends(mesh.position(mesh.from(h)), mesh.position(mesh.to(h))));
  }
  std::sort(known.begin(), known.end());
  std::vector<std::int32_t> seams;
  for (const std::int32_t h : borders) {
    const Ends back = ends(mesh.position(mesh.to(h)), mesh.position(mesh.from(h)));
    if (std::binary_search(known.begin(), known.end(), back)) seams.push_back(h);
  }
  return seams;
}

}  // namespace craze
