#include "craze/job/dataset/labels/crack_strips.h"

#include <algorithm>

#include "craze/base/segment_distance.h"

namespace craze {

Vec3 CrackStrips::point_of(const render::Hit& hit) const {
  const Triangle& t = scene_.mesh.triangles[hit.face];
  const Vec3& a = scene_.mesh.positions[t[0]];
  const double u = hit.u, v = hit.v;
  return a + u * (scene_.mesh.positions[t[1]] - a) + v * (scene_.mesh.positions[t[2]] - a);
}

Vec3 CrackStrips::normal_of(std::int32_t face) const {
  const Triangle& t = scene_.mesh.triangles[face];
  const Vec3& a = scene_.mesh.positions[t[0]];
  return (scene_.mesh.positions[t[1]] - a)
      .cross(scene_.mesh.positions[t[2]] - a)
      .stableNormalized();
}

NearestStrip CrackStrips::nearest(std::int32_t face, const Vec3& point, bool kept_only) const {
  NearestStrip nearest;
  const NearbyCracks& cracks = scene_.lines.cracks;
  const auto first = static_cast<std::int32_t>(cracks.first.empty() ? 0 : cracks.first[face]);
  const auto near = cracks.of(face);
  for (std::size_t k = 0; k < near.size(); ++k) {
    const auto line = first + static_cast<std::int32_t>(k);
    const std::int32_t crack = scene_.crack_of_line[line];
    if (crack < 0 || (kept_only && !noise_.dropped.empty() && noise_.dropped[crack])) continue;
    const double t = nearest_on_segment(point, near[k].a, near[k].b);
    const double half = half_width(line, t);
    if (half <= 0) continue;
    const double outside = (near[k].a + t * (near[k].b - near[k].a) - point).norm() - half;
    if (outside < nearest.outside) nearest = {outside, line, t};
  }
  return nearest;
}

double CrackStrips::distance(std::int32_t face, const Vec3& point, double limit) const {
  double least = limit;
  const NearbyCracks& cracks = scene_.lines.cracks;
  const std::size_t first = cracks.first.empty() ? 0 : cracks.first[face];
  const auto near = cracks.of(face);
  for (std::size_t k = 0; k < near.size(); ++k) {
    if (scene_.crack_of_line[first + k] < 0) continue;
    least = std::min(least, point_segment_distance(point, near[k].a, near[k].b));
  }
  return least;
}

double CrackStrips::half_width(std::int32_t line, double t) const {
  const auto& w = scene_.lines.width[line];
  return scene_.options.line_width * ((1 - t) * w[0] + t * w[1]) / 2;
}

double CrackStrips::seen_width(const NearestStrip& at, const Vec3& normal) const {
  const NearbyCrack& line = scene_.lines.cracks.segments[at.line];
  const Vec3 along = (line.b - line.a).stableNormalized();
  const Vec3 middle = line.a + at.along * (line.b - line.a);
  return scene_.projection.seen_width(middle, along, normal.cross(along), width(at));
}

}  // namespace craze
