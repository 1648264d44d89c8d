#include "craze/products/maps/map_surface.h"

#include "craze/engine/cracked_surface.h"
#include "craze/maps.h"
#include "craze/products/maps/map_cracks.h"

namespace craze {

MapSurface map_surface(const Result& result) {
  return map_surface(result, *result.state().surface);
}

MapSurface map_surface(const Result& result, const SurfaceMesh& uncut) {
  const CrackedSurface& state = result.state();
  check_uvs(uncut);
  MapSurface maps;
  maps.surface = uncut;
  const TriangleMesh& cut = state.mesh();
  const SurfaceMesh with_uvs = state.with_attributes(uncut);
  for (std::int32_t f = 0; f < cut.face_count(); ++f) {
    const auto corner = 3 * static_cast<std::size_t>(f);
    const std::int32_t face = state.asset ? state.asset->cut.face_source[f] : cut.source_face(f);
    maps.pieces.push_back({face,
                           state.fragments.face[f],
                           {with_uvs.corner_uvs[corner], with_uvs.corner_uvs[corner + 1],
                            with_uvs.corner_uvs[corner + 2]}});
  }
  maps.cracks = map_cracks(state.network);
  return maps;
}

}  // namespace craze
