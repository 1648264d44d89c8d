// A field of the simulation's mesh, on the asset's vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/engine/asset/crack_sides.h"
#include "craze/engine/asset/cut_asset.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// What a field is read from: the simulation's cut mesh, whose edges of the network are the curve
/// edges by which the asset was cut.
struct FieldSource {
  const TriangleMesh& mesh;
  const std::vector<Vec3>& field;          ///< #V of mesh
  const std::vector<std::int32_t>& parts;  ///< #F of mesh: the part that a face belongs to
  const std::vector<CrackSides>& sides;    ///< #curve edges
  bool is_beside = false;  ///< the curves lie beside the cracks of the mesh, as rough ones do
};

/// #V of cut. `positions`, #V of cut: where its vertices lie on the surface that the simulation's
/// mesh was made from. A vertex on a crack reads its own side of the crack, between the values at
/// the curve edge's ends; where curves lie beside the cracks, the nearest point that a walk from
/// the face at its side reaches over no crack. Any other one reads the nearest point of the
/// simulation's mesh, within the part that lies on the same sides of the same cracks as its own
/// part of the asset, so never across one that goes all the way. Asset and simulation face the same
/// way.
std::vector<Vec3> carry_field(const CutAsset& cut, const std::vector<Vec3>& positions,
                              const CrackCurves& curves, const FieldSource& source);

}  // namespace craze
