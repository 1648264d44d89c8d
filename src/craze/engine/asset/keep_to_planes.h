// Displacements that stay on the asset's large faces.
#pragma once

#include <vector>

#include "craze/engine/asset/cut_asset.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Turns the vectors of `field` (#V of cut) so that no vertex leaves a face around it: on a flat
/// place into its plane, on a hard edge along the edge, at a corner of three planes to nothing. On
/// a hard edge that a crack crosses the vector reaches as far along it as the crack's rim, moved by
/// the vector as it was, would meet it, so that gaps keep their width over the edge; at most twice
/// as far. Faces that meet at less than 25 degrees are one bent surface, whose mean plane counts.
/// Vertices of faces with no side as long as `fine`, a scan's, keep their vectors: there the
/// simulation's surface is the smoother one.
void keep_to_planes(const SurfaceMesh& asset, const CutAsset& cut, double fine,
                    std::vector<Vec3>& field);

}  // namespace craze
