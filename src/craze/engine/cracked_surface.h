// The state that a run ends in: what every product is made from.
#pragma once

#include <memory>
#include <vector>

#include "craze/engine/asset/carry_onto_asset.h"
#include "craze/engine/cycles.h"
#include "craze/mesh/components.h"
#include "craze/mesh/repair/repair_origin.h"
#include "craze/model/crack_network.h"
#include "craze/model/simulation.h"
#include "craze/recipe/own_lengths.h"
#include "craze/report.h"
#include "craze/surface_mesh.h"
#include "craze/surface_origin.h"
#include "craze/threads.h"

namespace craze {

/// What a run has grown, before its cracks are put into a surface (settle.h): the same whatever
/// [post] says.
struct GrownRun {
  Report report;        ///< as far as it goes by then; its recipe's [post] as it was asked for
  Yardstick yardstick;  ///< of the lengths of [post]
  LastCycle last;       ///< without its simulation
  /// As in SimulationSurface; empty: the simulation's mesh is the surface.
  std::vector<std::int32_t> asset_face;
};

/// Products speak of one mesh: that of the simulation, or the asset that its cracks were carried
/// onto.
struct CrackedSurface {
  /// What mesh() was cut out of: the simulation's mesh, or the asset.
  std::shared_ptr<const SurfaceMesh> surface;
  /// Per face of `surface`, where in the input it lies; null where it was remeshed.
  std::shared_ptr<const RepairOrigin> surface_origin;
  /// Colours and vertex attributes that `surface` has lost (welded_values.h), or null.
  std::shared_ptr<const SurfaceMesh> lost_values;
  std::shared_ptr<const Simulation> simulation;  ///< stopped: its cut mesh, its stress, its times
  std::shared_ptr<const GrownRun> run;
  std::shared_ptr<const CrackedAsset> asset;  ///< null: mesh() is the simulation's
  CrackNetwork network;                       ///< the cracks of mesh()
  Components fragments;                       ///< the parts of mesh()

  const TriangleMesh& mesh() const { return asset ? asset->mesh : simulation->mesh(); }
  /// #V of mesh(): the accumulated virtual displacement at the load that was reached, length.
  std::vector<Vec3> displacements() const;
  /// When each crack of mesh() opened, by its label (TriangleMesh::crack_of).
  std::vector<double> crack_times() const;
  /// mesh() with all that `uncut` has, whose faces are those of `surface`.
  SurfaceMesh with_attributes(const SurfaceMesh& uncut, const Threads& threads = 1) const;
  /// Per face of mesh(), where in the input it lies; empty where `surface` was remeshed.
  SurfaceOrigin origin() const;
};

}  // namespace craze
