#include "craze/products/opening/opened_origin.h"

#include "craze/engine/asset/cut_surface.h"
#include "craze/engine/cracked_surface.h"
#include "craze/mesh/closest_point.h"

namespace craze {

namespace {

/// Barycentric coordinates in a face of `cut` of a vertex of `base`, which `cut` was refined to: a
/// corner of the face, a copy of one, or a point of it.
Vec3 weights_in_face(const TriangleMesh& cut, std::int32_t f, const TriangleMesh& base,
                     std::int32_t v) {
  const Triangle& t = cut.triangle(f);
  for (int i = 0; i < 3; ++i) {
    if (cut.root(t[i]) == base.root(v)) return Vec3::Unit(i);
  }
  return nearest_weights(base.position(v), cut.position(t[0]), cut.position(t[1]),
                         cut.position(t[2]));
}

}  // namespace

SurfaceOrigin opened_origin(const Result& result, const OpenedSurface& surface) {
  const TriangleMesh& cut = result.state().mesh();
  const TriangleMesh& base = surface.base(result);
  const OpenedMesh& opened = surface.opened;
  SurfaceOrigin shut = result.state().origin();
  if (shut.face.empty() || opened.beside.size() == shut.face.size()) return shut;
  SurfaceOrigin origin;
  for (std::size_t f = 0; f < opened.beside.size(); ++f) {
    const std::int32_t beside = opened.beside[f];
    const std::int32_t from = surface.refined ? base.source_face(beside) : beside;
    origin.face.push_back(shut.face[from]);
    for (const std::int32_t v : opened.mesh.triangles[f]) {
      const Vec3 in_face = weights_in_face(cut, from, base, opened.vertex_of[v]);
      origin.weights.push_back(interpolate_corners(in_face, [&](int i) -> Vec3 {
        return shut.weights[3 * static_cast<std::size_t>(from) + i];
      }));
    }
  }
  origin.wall_begin = base.face_count();
  return origin;
}

}  // namespace craze
