// The cut asset with everything that the asset had.
#pragma once

#include "craze/engine/asset/cut_asset.h"
#include "craze/mesh/corners_on_surface.h"
#include "craze/surface_mesh.h"

namespace craze {

/// These positions and triangles, which are those of `cut`, with the asset's corner UVs and
/// normals, colours, materials, attributes and source_faces (the asset's, or the asset face's
/// number where it has none). Elements of the asset keep their bits. New ones are interpolated in
/// the face that they lie in, normals to unit length, so seams and hard edges stay what they are;
/// both sides of a crack, and both faces at an edge whose ends agree, find the same value to the
/// last bit.
SurfaceMesh cut_surface(const SurfaceMesh& asset, const CutAsset& cut,
                        const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);

}  // namespace craze
