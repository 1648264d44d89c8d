// The cracks of a simulation, cut into the mesh that the user owns.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/cut_asset.h"
#include "craze/engine/roughness/rough_network.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/crack_network.h"
#include "craze/surface_mesh.h"

namespace craze {

/// A finished simulation, as far as carrying it over goes.
struct SimulatedCracks {
  const TriangleMesh& mesh;                ///< cut; Simulation::mesh()
  const CrackNetwork& network;             ///< of that mesh
  const std::vector<Vec3>& displacement;   ///< #V of mesh
  const std::vector<std::int32_t>& parts;  ///< #F of mesh: the fragment of each face
  /// Per face of the surface that the simulation started with, which the network's faces number: an
  /// asset face that lies near it and on its side of any wall (remesh: source_faces).
  const std::vector<std::int32_t>& asset_face;
  /// #V of the asset: its vertices on the surface that the simulation's mesh was made from, where
  /// that has not the asset's bumps; null or empty: the asset itself.
  const std::vector<Vec3>* smooth = nullptr;
  /// What is cut in place of the network; null: the network as it is.
  const RoughNetwork* rough = nullptr;

  const CrackNetwork& drawn() const { return rough ? rough->network : network; }
};

struct CrackedAsset {
  CrackCurves curves;  ///< point n is node n of SimulatedCracks::drawn(), edge e its edge e
  /// Vertices and faces numbered as in mesh, which alone has positions and triangles once the run
  /// has ended.
  CutAsset cut;
  TriangleMesh mesh;  ///< what is cut: crack_of() numbers the edges of network
  /// Of mesh: the simulation's cracks as they lie on the asset, with their times, widths and order.
  /// Faces are the asset's.
  CrackNetwork network;
  std::vector<Vec3> displacement;  ///< #V of mesh
};

/// The network as curves: each node at the nearest point of the asset, looked for from the face
/// that its own is known to come from, so that it stays on its side of a thin wall. `asset` has its
/// vertices on the surface that the network's was made from.
CrackCurves crack_curves(const CrackNetwork& network, const SurfaceMesh& asset,
                         const AssetTopology& topology,
                         const std::vector<std::int32_t>& asset_face);

/// The same without displacements, of a run on a flat surface that may repeat: `asset` is the mesh
/// that it started with, and the network, of that period, its own or a rough one.
CrackedAsset carry_onto_plane(const SurfaceMesh& asset, const CrackNetwork& network,
                              const Context& context);

/// The asset must suit the constructor of TriangleMesh, which throws what it finds (repair.h):
/// faces are neighbours where they share vertices. snap as in CutOptions; a twentieth of the mean
/// length of the network's edges if negative. Reports the phase "carry"; throws Cancelled.
CrackedAsset carry_onto_asset(const SurfaceMesh& asset, const SimulatedCracks& cracked, double snap,
                              const Context& context);

/// The asset as a mesh that knows its cracks: faces as in `cut`, crack_of() the index into
/// cut.edges, copies of a vertex with one root. Vertices that the cracks make come after the
/// others, in another order than in `cut`, whose vertices are renumbered to the mesh's.
TriangleMesh crack_mesh(CutAsset& cut, const Period& period = {});

}  // namespace craze
