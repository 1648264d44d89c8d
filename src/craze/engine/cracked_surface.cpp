#include "craze/engine/cracked_surface.h"

#include "craze/engine/asset/cut_surface.h"
#include "craze/mesh/transfer_attributes.h"

namespace craze {

namespace {

/// 3 #F: the corners of the mesh in the faces of the surface that it was cut out of.
std::vector<Vec3> corner_weights(const CrackedSurface& state) {
  const TriangleMesh& mesh = state.mesh();
  std::vector<Vec3> weights;
  weights.reserve(3 * mesh.triangles().size());
  if (!state.asset) {
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      const TrianglePoint at =
          locate_in_triangle(*state.surface, mesh.source_face(h / 3), mesh.position(mesh.from(h)));
      Vec3& w = weights.emplace_back(Vec3::Zero());
      for (int i = 0; i < 3; ++i) w[at.corners[i]] += at.weights[i];
    }
    return weights;
  }
  const CutAsset& cut = state.asset->cut;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) weights.push_back(Vec3::Unit(h % 3));
  for (std::size_t p = 0; p < cut.parts.size(); ++p) {
    for (std::size_t i = 0; i < 3; ++i) {
      weights[3 * static_cast<std::size_t>(cut.parts[p]) + i] = cut.part_weights[3 * p + i];
    }
  }
  return weights;
}

}  // namespace

std::vector<Vec3> CrackedSurface::displacements() const {
  if (asset) return asset->displacement;
  std::vector<Vec3> displacement(mesh().positions().size());
  for (std::int32_t v = 0; v < mesh().vertex_count(); ++v) {
    displacement[v] = simulation->displacement(v);
  }
  return displacement;
}

std::vector<double> CrackedSurface::crack_times() const {
  if (!asset) return simulation->crack_times();
  std::vector<double> times;
  for (const CrackEdge& edge : network.edges) times.push_back(edge.time);
  return times;
}

SurfaceMesh CrackedSurface::with_attributes(const SurfaceMesh& uncut,
                                            const Threads& threads) const {
  if (!asset) return transfer_attributes(uncut, mesh(), threads);
  return cut_surface(uncut, asset->cut, mesh().positions(), mesh().triangles());
}

SurfaceOrigin CrackedSurface::origin() const {
  SurfaceOrigin origin;
  if (!surface_origin || surface_origin->face.empty()) return origin;
  origin.weights = corner_weights(*this);
  origin.face.reserve(mesh().triangles().size());
  for (std::int32_t f = 0; f < mesh().face_count(); ++f) {
    const std::int32_t source = asset ? asset->cut.face_source[f] : mesh().source_face(f);
    origin.face.push_back(surface_origin->face[source]);
    const auto corner = [&](int i) -> Vec3 {
      return surface_origin->weights(3 * static_cast<std::size_t>(source) +
                                     static_cast<std::size_t>(i));
    };
    for (std::size_t c = 3 * static_cast<std::size_t>(f); c < 3 * static_cast<std::size_t>(f) + 3;
         ++c) {
      origin.weights[c] = interpolate_corners(origin.weights[c], corner);
    }
  }
  origin.wall_begin = mesh().face_count();
  return origin;
}

}  // namespace craze
