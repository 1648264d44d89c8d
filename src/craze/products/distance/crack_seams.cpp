#include "craze/products/distance/crack_seams.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "craze/products/distance/seams.h"

namespace craze {

namespace {

/// Files round to single precision, and normals to less.
constexpr double same_uv = 1e-6, same_color = 1e-3, same_normal = 1e-3;

bool is_same_corner(const SurfaceMesh& s, std::int32_t c, std::int32_t d) {
  if (!s.corner_uvs.empty() && !((s.corner_uvs[c] - s.corner_uvs[d]).norm() <= same_uv)) {
    return false;
  }
  if (!s.corner_normals.empty() &&
      !((s.corner_normals[c] - s.corner_normals[d]).norm() <= same_normal)) {
    return false;
  }
  if (s.vertex_colors.empty()) return true;
  const Color& a = s.vertex_colors[s.triangles[c / 3][c % 3]];
  const Color& b = s.vertex_colors[s.triangles[d / 3][d % 3]];
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](float x, float y) { return std::abs(x - y) <= same_color; });
}

/// Whether nothing but a cut parts the two sides of an edge.
bool is_same_side(const SurfaceMesh& s, std::int32_t h, std::int32_t g) {
  if (!s.face_materials.empty() && s.face_materials[h / 3] != s.face_materials[g / 3]) return false;
  if (!s.face_objects.empty() && s.face_objects[h / 3] != s.face_objects[g / 3]) return false;
  return is_same_corner(s, h, TriangleMesh::next(g)) && is_same_corner(s, TriangleMesh::next(h), g);
}

using Place = std::tuple<double, double, double, double, double, double>;

Place place(const Vec3& a, const Vec3& b) {
  return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
}

/// Takes away the sides that have others on the very same edge, none of which looks the same.
void remove_texture_seams(const SurfaceMesh& surface, const TriangleMesh& mesh,
                          std::vector<std::int32_t>& sides) {
  const auto from = [&](std::int32_t h) { return mesh.position(mesh.from(h)); };
  const auto to = [&](std::int32_t h) { return mesh.position(mesh.to(h)); };
  std::vector<std::pair<Place, std::int32_t>> known;
  for (const std::int32_t h : sides) known.emplace_back(place(from(h), to(h)), h);
  std::sort(known.begin(), known.end());
  const auto is_seam = [&](std::int32_t h) {
    const Place back = place(to(h), from(h));
    auto other = std::lower_bound(known.begin(), known.end(), std::pair(back, std::int32_t{0}));
    bool any = false;
    for (; other != known.end() && other->first == back; ++other) {
      if (is_same_side(surface, h, other->second)) return false;
      any = true;
    }
    return any;
  };
  sides.erase(std::remove_if(sides.begin(), sides.end(), is_seam), sides.end());
}

/// Whether most triangles are parted from all that they touch; `sides` ascend.
bool repeats_every_vertex(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides) {
  std::int64_t alone = 0;
  for (std::size_t i = 0; i + 2 < sides.size(); ++i) {
    if (sides[i] % 3 == 0 && sides[i + 2] == sides[i] + 2) ++alone;
  }
  return 2 * alone > mesh.face_count();
}

}  // namespace

std::vector<std::int32_t> crack_seams(const SurfaceMesh& surface, const TriangleMesh& mesh) {
  std::vector<std::int32_t> sides = seam_sides(mesh);
  const Attribute* distance = find_attribute(surface.vertex_attributes, "crack_distance");
  if (distance) {
    const auto is_off_crack = [&](std::int32_t h) {
      return distance->values[mesh.from(h)] > 0 || distance->values[mesh.to(h)] > 0;
    };
    sides.erase(std::remove_if(sides.begin(), sides.end(), is_off_crack), sides.end());
    return sides;
  }
  if (repeats_every_vertex(mesh, sides)) return {};
  remove_texture_seams(surface, mesh, sides);
  return sides;
}

}  // namespace craze
