#include "craze/products/maps/map_surface.h"

#include "craze/engine/cracked_surface.h"
#include "craze/maps.h"
#include "craze/mesh/transfer_attributes.h"
#include "craze/products/distance/crack_distance.h"
#include "craze/products/maps/map_cracks.h"
#include "craze/products/opening/bend_refinement.h"
#include "craze/products/opening/curl.h"

namespace craze {

std::vector<MapPiece> faces_as_pieces(const std::vector<Vec2>& corner_uvs) {
  std::vector<MapPiece> pieces;
  for (std::size_t f = 0; 3 * f < corner_uvs.size(); ++f) {
    pieces.push_back({static_cast<std::int32_t>(f),
                      0,
                      {corner_uvs[3 * f], corner_uvs[3 * f + 1], corner_uvs[3 * f + 2]}});
  }
  return pieces;
}

MapSurface map_surface(const Result& result, const PostParameters& post, const Context& context) {
  return map_surface(result, *result.state().surface, post, context);
}

MapSurface map_surface(const Result& result, const SurfaceMesh& uncut, const PostParameters& post,
                       const Context& context) {
  const CrackedSurface& state = result.state();
  check_uvs(uncut);
  MapSurface maps;
  maps.surface = uncut;
  const TriangleMesh& cut = state.mesh();
  const SurfaceMesh with_uvs = state.with_attributes(uncut, context.threads);
  for (std::int32_t f = 0; f < cut.face_count(); ++f) {
    const auto corner = 3 * static_cast<std::size_t>(f);
    const std::int32_t face = state.asset ? state.asset->cut.face_source[f] : cut.source_face(f);
    maps.pieces.push_back({face,
                           state.fragments.face[f],
                           {with_uvs.corner_uvs[corner], with_uvs.corner_uvs[corner + 1],
                            with_uvs.corner_uvs[corner + 2]}});
  }
  maps.cracks = map_cracks(state.network, cut);
  maps.cut = {result.shared_state(), &cut};
  maps.seed = result.report().recipe.simulation.seed;
  if (post.curl != 0 && state.asset) refine_to_bend(maps, with_uvs, context);
  return maps;
}

double mean_crack_distance(const MapSurface& maps) {
  double length = 0, area = 0;
  for (const MapCrack& crack : maps.cracks) length += (crack.b - crack.a).norm();
  for (const Triangle& t : maps.surface.triangles) {
    const Vec3& p = maps.surface.positions[t[0]];
    area += (maps.surface.positions[t[1]] - p).cross(maps.surface.positions[t[2]] - p).norm() / 2;
  }
  return length > 0 ? 2 * area / length : 0;
}

void refine_to_bend(MapSurface& maps, const SurfaceMesh& whole, const Context& context) {
  const double length = curl_length(mean_crack_distance(maps));
  if (!(length > 0)) return;
  const auto refined =
      refined_to_bend(*maps.cut, crack_distances(*maps.cut, bend_reach(length), context), length);
  if (!refined) return;
  SurfaceMesh uvs;
  uvs.positions = whole.positions;
  uvs.triangles = whole.triangles;
  uvs.corner_uvs = whole.corner_uvs;
  uvs = transfer_attributes(uvs, *refined, context.threads);
  std::vector<MapPiece> pieces;
  for (std::int32_t f = 0; f < refined->face_count(); ++f) {
    const auto corner = 3 * static_cast<std::size_t>(f);
    MapPiece piece = maps.pieces[refined->source_face(f)];
    piece.uvs = {uvs.corner_uvs[corner], uvs.corner_uvs[corner + 1], uvs.corner_uvs[corner + 2]};
    pieces.push_back(piece);
  }
  maps.pieces = std::move(pieces);
  maps.cut = refined;
}

}  // namespace craze
