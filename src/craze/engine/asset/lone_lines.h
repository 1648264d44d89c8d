// Cracks of a single edge, which two tips would hold shut.
#pragma once

#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/curve_sites.h"
#include "craze/engine/asset/refine_asset.h"

namespace craze {

/// Halves every line whose two ends no other line touches, and the faces beside it: both its ends
/// stay single vertices, so only a vertex between them can open.
void halve_lone_lines(const AssetTopology& topology, SiteTable& sites, RefinedAsset& refined);

}  // namespace craze
