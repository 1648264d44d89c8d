// How far a texture slides when a mesh is remeshed and cut.
#pragma once

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include "craze/mesh/closest_point.h"
#include "craze/surface_mesh.h"

namespace craze::test {

struct TextureShift {
  double worst = 0, mean = 0;  ///< in units of the texture
  double displaced = 0;        ///< share of the area that slides by more than 0.01
};

/// Compares the UV at the middle of each face of `output` with that of the nearest point on the
/// polygon of `input` that it came from (source_faces).
inline TextureShift texture_shift(const SurfaceMesh& input, const SurfaceMesh& output) {
  std::map<std::int32_t, std::vector<std::size_t>> triangles_of;
  for (std::size_t f = 0; f < input.triangles.size(); ++f) {
    triangles_of[input.source_faces.empty() ? static_cast<std::int32_t>(f) : input.source_faces[f]]
        .push_back(f);
  }
  TextureShift shift;
  double total = 0;
  for (std::size_t f = 0; f < output.triangles.size(); ++f) {
    Vec3 middle = Vec3::Zero();
    Vec2 uv = Vec2::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
      middle += output.positions[output.triangles[f][c]] / 3;
      uv += output.corner_uvs[3 * f + c] / 3;
    }
    double nearest = std::numeric_limits<double>::infinity();
    Vec2 expected = Vec2::Zero();
    for (const std::size_t t : triangles_of.at(output.source_faces[f])) {
      Vec3 p[3];
      for (std::size_t c = 0; c < 3; ++c) p[c] = input.positions[input.triangles[t][c]];
      const Vec3 w = nearest_weights(middle, p[0], p[1], p[2]);
      const double distance = (w[0] * p[0] + w[1] * p[1] + w[2] * p[2] - middle).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      expected = Vec2::Zero();
      for (std::size_t c = 0; c < 3; ++c) expected += w[c] * input.corner_uvs[3 * t + c];
    }
    const double off = (uv - expected).norm();
    shift.worst = std::max(shift.worst, off);
    const Vec3& p = output.positions[output.triangles[f][0]];
    const double area = (output.positions[output.triangles[f][1]] - p)
                            .cross(output.positions[output.triangles[f][2]] - p)
                            .norm();
    total += area;
    if (off > 0.01) shift.displaced += area;
    shift.mean += off / static_cast<double>(output.triangles.size());
  }
  shift.displaced /= total;
  return shift;
}

}  // namespace craze::test
