// A user's own mesh, cut along curves.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/engine/asset/trace_curves.h"
#include "craze/surface_mesh.h"

namespace craze {

struct CutOptions {
  /// Length: a curve that passes a vertex, an edge's end or another curve's point so near goes
  /// through it, which saves slivers. At most a sixteenth of the edge or face at hand.
  double snap = 0;
  /// The asset with its vertices on the surface where the curves are straight, such as one without
  /// its bumps; null: the asset itself.
  const SurfaceMesh* straight_on = nullptr;
  Period period = {};  ///< of the asset, which is flat then
};

/// An edge that the cut opened.
struct CutEdge {
  std::int32_t curve_edge;  ///< the one it lies on; where several do, the first
  /// Its sides, halfedges 3f+i from corner i to corner i+1 of face f: side[0] has the curve edge's
  /// own direction, so its face lies left of the curve. −1: on the asset's border, open already.
  std::array<std::int32_t, 2> side;
};

struct CutReport {
  std::int32_t split_faces = 0;  ///< of the asset
  TraceReport traced;
  std::int32_t lost_segments = 0;  ///< pieces that their face had no room for
};

/// What holds of the result:
/// - Vertices and faces of the asset keep their index. A vertex keeps its bits. A face that no
/// curve
///   passes keeps its corners, but for those at a vertex where a crack parts the faces round it:
///   there all sides but the first have a copy of the vertex.
/// - A split face is the union of its parts, to the rounding of their corners: new vertices lie in
///   its plane, parts face as it does and none is flat. Both faces at an edge are split alike.
/// - Every curve edge that is not lost is a chain of open edges between the vertices of its points.
///   Curves that meet or cross share a vertex. A crack that ends inside the surface ends in one
///   vertex, a tip. Where a curve turns back onto itself, the vertex of its turn is that where its
///   ways part (spurs.h).
/// - Two corners of faces that share a vertex of the asset and lie on one side share it still.
/// - The same input gives the same bytes. Cost: that of neighbourhoods, O(#V log #V + #F), and
///   O(n log n) in the number of pieces that curves fall into at edges.
struct CutAsset {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<SurfacePoint> new_vertices;  ///< where on the asset those after the asset's own lie
  std::vector<std::int32_t>
      root;  ///< #V: the vertex that a crack made it a copy of; itself if none
  std::vector<std::int32_t> face_source;   ///< #F: asset faces
  std::vector<std::int32_t> parts;         ///< the faces that are parts of a split one, ascending
  std::vector<Vec3> part_weights;          ///< 3 per part: its corners in face_source; exact sums
  std::vector<CutEdge> edges;              ///< by curve edge, along it
  std::vector<std::int32_t> point_vertex;  ///< per point of the curves one of its vertices
  CutReport report;
};

/// Lays the curves onto the asset and cuts it open along them. The asset may have seams, borders,
/// edges of three faces, triangles without area; `topology` is its own.
/// Throws Error(request) where a point names no face or an edge no point; Cancelled.
CutAsset cut_asset(const SurfaceMesh& asset, const AssetTopology& topology,
                   const CrackCurves& curves, const CutOptions& options, const Context& context);

/// #V of cut: where its vertices lie on the asset with the asset's vertices at `places`, #V of it.
std::vector<Vec3> positions_on(const CutAsset& cut, const SurfaceMesh& asset,
                               const std::vector<Vec3>& places);

}  // namespace craze
