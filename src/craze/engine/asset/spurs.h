// Cracks that turn back onto themselves.
#pragma once

#include <vector>

#include "craze/engine/asset/refine_asset.h"
#include "craze/engine/asset/trace_curves.h"

namespace craze {

/// A curve that turns back so sharply that both ways came to lie on the same edges would be cut
/// beside its turn into a spur with a tip. Such edges are no lines any more, and what stood for the
/// turn stands where its ways part. Ends of curves stay; where pieces were lost all ends do.
void drop_spurs(const std::vector<CurvePiece>& pieces, RefinedAsset& refined);

}  // namespace craze
