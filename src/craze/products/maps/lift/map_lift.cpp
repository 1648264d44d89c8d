#include "craze/products/maps/lift/map_lift.h"

#include <algorithm>

#include "craze/mesh/closest_point.h"
#include "craze/products/opening/curl.h"
#include "craze/products/opening/surface_extension.h"

namespace craze {

namespace {

Vec3 lifted(const Vec2& p) {
  return {p.x(), p.y(), 0};
}

/// #V of the cut mesh.
std::vector<double> lift_of_vertices(const MapSurface& maps, const GrooveSizes& sizes) {
  const TriangleMesh& cut = *maps.cut;
  const auto count = static_cast<std::size_t>(cut.vertex_count());
  std::vector<double> half_at_root(count, -1);
  for (std::size_t i = 0; i < maps.cracks.size(); ++i) {
    for (std::size_t end = 0; end < 2; ++end) {
      const std::int32_t root = maps.cracks[i].roots[end];
      if (root < 0) continue;
      half_at_root[root] = std::max(half_at_root[root], sizes.half_width[i][end]);
    }
  }
  std::vector<std::uint8_t> on_crack(count, 0);
  std::vector<double> lift(count, 0);
  for (std::size_t v = 0; v < count; ++v) {
    const double half = half_at_root[cut.root(static_cast<std::int32_t>(v))];
    if (half < 0) continue;
    on_crack[v] = 1;
    lift[v] = sizes.curl * half;
  }
  return extend_over_surface(cut, on_crack, lift, curl_length(mean_crack_distance(maps)));
}

/// #V: the mean slope of the faces around, by their areas.
std::vector<Vec3> slopes_of(const TriangleMesh& mesh, const std::vector<double>& values) {
  std::vector<Vec3> slope(values.size(), Vec3::Zero());
  std::vector<double> area(values.size(), 0);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle& t = mesh.triangle(f);
    const Vec3 a = mesh.corner(f, 0), b = mesh.corner(f, 1), c = mesh.corner(f, 2);
    const Vec3 normal = (b - a).cross(c - a);
    const double twice = normal.norm();
    if (!(twice > 0)) continue;
    const Vec3 across = values[t[0]] * (c - b) + values[t[1]] * (a - c) + values[t[2]] * (b - a);
    const Vec3 times_area = (normal / twice).cross(across) / 2;
    for (const std::int32_t v : t) {
      slope[v] += times_area;
      area[v] += twice / 2;
    }
  }
  for (std::size_t v = 0; v < slope.size(); ++v) {
    if (area[v] > 0) slope[v] /= area[v];
  }
  return slope;
}

}  // namespace

MapLift::MapLift(const MapSurface& maps, const MapFaces& faces, const GrooveSizes& sizes) {
  if (sizes.curl == 0 || !maps.cut || maps.cracks.empty()) return;
  const TriangleMesh& cut = *maps.cut;
  const std::vector<double> lift = lift_of_vertices(maps, sizes);
  const std::vector<Vec3> slopes = slopes_of(cut, lift);
  patches_.resize(maps.pieces.size());
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    const MapPiece& piece = maps.pieces[i];
    const auto f = static_cast<std::int32_t>(i);
    const FacePlane& plane = faces[piece.face].plane;
    Patch& patch = patches_[i];
    double corners = 0, sides = 0;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t v = cut.triangle(f)[k];
      patch.corners[k] = faces.at(piece.face, piece.uvs[k]);
      patch.slopes[k] = {slopes[v].dot(plane.x), slopes[v].dot(plane.y)};
      patch.at_corner[k] = lift[v];
      corners += lift[v] / 3;
      // By the edge in space, which both its faces know alike.
      const int next = (k + 1) % 3;
      const std::int32_t w = cut.triangle(f)[next];
      const Vec3 way = cut.corner(f, next) - cut.corner(f, k);
      patch.on_side[k] = {lift[v] + slopes[v].dot(way) / 3, lift[w] - slopes[w].dot(way) / 3};
      sides += (patch.on_side[k][0] + patch.on_side[k][1]) / 6;
      for (const double control : {lift[v], patch.on_side[k][0], patch.on_side[k][1]}) {
        lowest_ = std::min(lowest_, control);
        highest_ = std::max(highest_, control);
      }
    }
    patch.inside = sides + (sides - corners) / 2;
    lowest_ = std::min(lowest_, patch.inside);
    highest_ = std::max(highest_, patch.inside);
  }
}

double MapLift::Patch::at(const Vec3& w) const {
  double sum = 6 * w[0] * w[1] * w[2] * inside;
  for (int k = 0; k < 3; ++k) {
    const double a = w[k], b = w[(k + 1) % 3];
    sum += a * a * a * at_corner[k] + 3 * a * b * (a * on_side[k][0] + b * on_side[k][1]);
  }
  return sum;
}

double MapLift::at(std::int32_t piece, const Vec2& p) const {
  if (patches_.empty()) return 0;
  const Patch& patch = patches_[piece];
  const auto& c = patch.corners;
  const Vec3 w = nearest_weights(lifted(p), lifted(c[0]), lifted(c[1]), lifted(c[2]));
  const Vec2 beyond = p - (w[0] * c[0] + w[1] * c[1] + w[2] * c[2]);
  const Vec2 slope = w[0] * patch.slopes[0] + w[1] * patch.slopes[1] + w[2] * patch.slopes[2];
  return std::clamp(patch.at(w) + slope.dot(beyond), lowest_, highest_);
}

}  // namespace craze
