// An asset whose faces are split along curves, and nowhere else.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/curve_sites.h"
#include "craze/engine/asset/trace_curves.h"
#include "craze/surface_mesh.h"

namespace craze {

/// An edge of the refined asset that lies on a curve.
struct CurveLine {
  std::int32_t a, b;  ///< sites, a < b
  std::int32_t curve_edge;
};

/// The asset's vertices come first, in its order. Faces that no curve touches stand where they
/// stood; of a split face the first part takes its place and the others follow at the end.
struct RefinedAsset {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<SurfacePoint> new_vertices;  ///< on the asset, for vertices after the asset's own
  std::vector<std::int32_t> root;          ///< copies (part_sides.h): what each is a copy of
  std::vector<std::int32_t> face_source;   ///< #F: asset faces
  std::vector<std::int32_t> parts;         ///< the faces that are parts of a split one, ascending
  std::vector<std::int32_t> part_sites;    ///< 3 per part: the sites at its corners
  std::vector<CurveLine> lines;            ///< ascending by a, b; each edge once
  std::vector<std::int32_t> same_site;     ///< for each site the one that stands for it
  std::int32_t lost_segments = 0;          ///< pieces that a face had no room for
};

/// Splits each face that a piece or one of `points` (sites) touches, once, along all of its pieces.
/// Sites that neither name stay out of the mesh. A face is split the same way as its neighbour
/// along their common edge, whatever the number of faces there. A new vertex is a barycentric
/// combination of its face's corners; on an edge whose faces use different vertices (a seam) each
/// has its own.
RefinedAsset refine_asset(const SurfaceMesh& asset, const AssetTopology& topology, SiteTable& sites,
                          const std::vector<CurvePiece>& pieces,
                          const std::vector<std::int32_t>& points, double snap);

}  // namespace craze
