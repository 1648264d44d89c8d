// What maps are baked of: a surface, its pieces and its cracks, whatever they come from.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <set>
#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/recipe.h"
#include "craze/surface_mesh.h"

namespace craze {

/// A straight piece of a crack.
struct MapCrack {
  Vec3 a, b;                      ///< in the plane of `face`; it grew from a to b
  std::array<double, 2> width{};  ///< at a and b: opening of [IO06 Eq. 9] with γ = 1, length
  double time = 0;                ///< load at which it opened
  std::int32_t number = 0;        ///< of the crack, from 0
  std::int32_t face = -1;         ///< of the surface; one that holds it
  std::array<double, 2> times{};  ///< at a and b, without a step along the crack
  /// Vertices of MapSurface::cut at a and b: the first of each place (TriangleMesh::root).
  std::array<std::int32_t, 2> roots{-1, -1};
};

/// A part of a face that no crack crosses.
struct MapPiece {
  std::int32_t face;
  std::int32_t fragment;
  std::array<Vec2, 3> uvs;  ///< of its corners; pieces share the bits of these where they touch
};

/// The pieces of a face cover it.
struct MapSurface {
  SurfaceMesh surface;  ///< without the cracks; manifold, vertices welded
  /// Of a tile, which is written cut open along its border: its triangles by vertices that are one
  /// where it continues on itself. Empty: those of the surface.
  std::vector<Triangle> joined;
  double diagonal = 0;  ///< what hairlines are measured by, length; 0: the box around the surface
  std::vector<MapPiece> pieces;
  /// Its faces are the pieces, in their order, and its cracks are open. Null: not known.
  std::shared_ptr<const TriangleMesh> cut;
  std::vector<MapCrack> cracks;
  bool has_widths = true;  ///< the cracks' widths are known
  bool has_times = true;   ///< and when they opened
  std::uint64_t seed = 1;  ///< of what is random about rims
  bool apart = false;      ///< materials lie in different UV sets: a picture has one alone
  /// Materials whose maps are not wanted; without any left there are none.
  std::set<std::int32_t> left_out;

  bool is_tile() const { return !joined.empty(); }
  /// By which faces are neighbours.
  const std::vector<Triangle>& neighbours() const { return is_tile() ? joined : surface.triangles; }
};

/// Whole faces, whose corners have these UVs (3 #F).
std::vector<MapPiece> faces_as_pieces(const std::vector<Vec2>& corner_uvs);

/// `post`: where it curls, pieces are small enough to bend (bend_refinement.h). Throws
/// Error(request) where there are no UVs, and Cancelled.
MapSurface map_surface(const Result& result, const PostParameters& post, const Context& context);

/// The same in other UVs: `uncut` is what the run cut its cracks into (CrackedSurface::surface),
/// but for its UVs and normals.
MapSurface map_surface(const Result& result, const SurfaceMesh& uncut, const PostParameters& post,
                       const Context& context);

/// Of a mesh whose shut cracks are open edges that lie on each other (distance/seams.h). Takes
/// widths from the vertex attribute displacement, times from crack_time, and pieces from the face
/// attribute fragment or, without it, from what hangs together. Cracks are numbered by the lines
/// between junctions. Throws Error(request) where there are no cracks or no UVs, and Cancelled.
MapSurface map_surface(const SurfaceMesh& cracked, const PostParameters& post,
                       const Context& context);

/// 2 × area / length of the cracks; 0 without any.
double mean_crack_distance(const MapSurface& maps);

/// Makes the pieces small enough to bend: of `whole`, whose faces are those of `cut` now, with UVs.
void refine_to_bend(MapSurface& maps, const SurfaceMesh& whole, const Context& context);

}  // namespace craze
