// The two sides of each crack, parted.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/curve_sites.h"
#include "craze/engine/asset/refine_asset.h"

namespace craze {

/// A line of the refined asset with the halfedges 3f+i on it.
struct LineSides {
  std::vector<std::int32_t> first;      ///< #lines + 1, offsets into halfedges
  std::vector<std::int32_t> halfedges;  ///< ascending for each line
};

/// Gives each sector of faces between cracks a vertex of its own wherever lines meet a vertex: the
/// sector of the lowest face keeps it, the others get copies. Where a place has several fans of
/// faces to begin with they stay joined, each by its first sector.
LineSides part_sides(const SurfaceMesh& asset, const AssetTopology& topology, SiteTable& sites,
                     RefinedAsset& refined);

}  // namespace craze
