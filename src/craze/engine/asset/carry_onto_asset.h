// The cracks of a simulation, cut into the mesh that the user owns.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/engine/asset/cut_asset.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/crack_network.h"
#include "craze/surface_mesh.h"

namespace craze {

/// A finished simulation, as far as carrying it over goes.
struct CrackedSurface {
  const TriangleMesh& mesh;                ///< cut; Simulation::mesh()
  const CrackNetwork& network;             ///< of that mesh
  const std::vector<Vec3>& displacement;   ///< #V of mesh
  const std::vector<std::int32_t>& parts;  ///< #F of mesh: the fragment of each face
  /// Per face of the surface that the simulation started with, which the network's faces number: an
  /// asset face that lies near it and on its side of any wall (remesh: source_faces).
  const std::vector<std::int32_t>& asset_face;
};

struct CrackedAsset {
  CrackCurves curves;              ///< point n is the network's node n, edge e its edge e
  CutAsset cut;                    ///< CutEdge::curve_edge numbers the network's edges: time, width
  SurfaceMesh surface;             ///< the cut asset with all of the asset's attributes
  std::vector<Vec3> displacement;  ///< #V of cut
};

/// The network as curves: each node at the nearest point of the asset, looked for from the face
/// that its own is known to come from, so that it stays on its side of a thin wall.
CrackCurves crack_curves(const CrackNetwork& network, const SurfaceMesh& asset,
                         const std::vector<std::int32_t>& asset_face);

/// snap as in CutOptions; a twentieth of the mean length of the network's edges if negative.
CrackedAsset carry_onto_asset(const SurfaceMesh& asset, const CrackedSurface& cracked, double snap);

/// The asset as a mesh that knows its cracks, for what reads a simulation's: faces as in `cut`,
/// crack_of() the index into cut.edges, copies of a vertex with one root; vertices that the cracks
/// make come after the others, in another order than in `cut`. vertex_of receives, per vertex, the
/// one of `cut`. The asset must suit the constructor of TriangleMesh, which throws what it finds.
TriangleMesh crack_mesh(const CutAsset& cut, std::vector<std::int32_t>& vertex_of);

}  // namespace craze
