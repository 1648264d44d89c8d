// The mesh that cracks: from a repaired surface and a recipe.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/period.h"
#include "craze/context.h"
#include "craze/mesh/numbering/numbering.h"
#include "craze/recipe.h"
#include "craze/surface_mesh.h"

namespace craze {

/// What the simulation runs on.
struct SimulationSurface {
  /// With every attribute of the repaired input, numbered by spatial_numbering(): what lies near in
  /// memory is read faster, and cracks do not depend on the order in which a file lists things.
  SurfaceMesh mesh;
  /// Of `mesh` where it is the repaired input itself: from the input's numbers; else empty.
  Numbering numbering = {};
  /// #F, 1 where a multiplier of the recipe is zero at the input's triangle or one of its corners;
  /// empty: nowhere. A finer mesh mixes what the corners hold, but not this.
  std::vector<std::uint8_t> forbidden = {};
  /// The repaired input, where the mesh is another one and mesh.output asks for the input's
  /// triangles; else empty.
  SurfaceMesh asset = {};
  /// #F: a face of the asset that lies near each, on its side of any wall.
  std::vector<std::int32_t> asset_face = {};
  Period period = {};             ///< of `mesh`
  std::vector<double> mask = {};  ///< #F, how freely each face cracks (crack_mask.h); empty: all do
  /// #V of the asset: its vertices without the bumps that the mesh leaves out; empty: it leaves out
  /// none.
  std::vector<Vec3> smooth = {};
};

/// Mean length of the triangles' edges, those between two triangles counted twice; there must be a
/// triangle.
double mean_edge(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                 const Period& period = {});

/// mesh.edge "keep": the input itself. A length: remeshed to it. "auto": remeshed to a quarter of
/// the screening length where the input's edges are longer than that on average, and with
/// mesh.output "asset" where they are shorter than half of it, a scan, whose bumps up to half of
/// that height are then smoothed away; else the input itself. Throws Error(request) for a spacing
/// or edge that the object or this machine's memory is too small for.
/// With a period the input is a plane without attributes that needs remeshing. The edge that "auto"
/// takes is multiplied by `coarseness` ≥ 1.
SimulationSurface simulation_surface(SurfaceMesh repaired, const Recipe& recipe,
                                     const Context& context, const Period& period = {},
                                     double coarseness = 1);

/// SimulationSurface::smooth of an asset that it was made from by the same recipe.
std::vector<Vec3> smooth_asset(const SurfaceMesh& asset, const Recipe& recipe,
                               double coarseness = 1);

}  // namespace craze
