// A tile: a square of cracked material that continues on itself.
#pragma once

#include <memory>
#include <string>

#include "craze/context.h"
#include "craze/engine/asset/carry_onto_asset.h"
#include "craze/mesh/components.h"
#include "craze/model/crack_network.h"
#include "craze/model/simulation.h"
#include "craze/recipe.h"
#include "craze/report.h"
#include "craze/surface_mesh.h"

namespace craze {

/// What lengths of a tile are in: the square [0, side]² of the plane z = 0.
struct TileSize {
  double side = 1;             ///< model units, > 0
  double metres_per_unit = 0;  ///< 0: not known; mesh.unit says it then, where it is given
};

/// Of the text of a side: "2", in the tile's own unit, or a length of the world such as "40cm",
/// which makes that unit the metre. Throws Error(usage).
TileSize read_tile_size(const std::string& period);

/// A finished run on a flat torus (Period): its cracks run on over the sides of the square, which
/// are no lines of it.
struct CrackedTile {
  Recipe recipe;        ///< as it was run: lengths resolved
  SurfaceMesh surface;  ///< the simulation's mesh before its first cut
  std::shared_ptr<const Simulation> simulation;
  std::shared_ptr<const CrackedAsset> rough;  ///< what roughness cut; null: mesh() is as it grew
  CrackNetwork network;                       ///< the cracks of mesh()
  Components fragments;                       ///< the parts of mesh()
  Report report;

  const TriangleMesh& mesh() const { return rough ? rough->mesh : simulation->mesh(); }
  /// The face of `surface` that a face of mesh() is part of.
  std::int32_t source_face(std::int32_t f) const {
    return rough ? rough->cut.face_source[f] : mesh().source_face(f);
  }
};

/// Cracks a tile by a recipe, as crack() does a plate: what is relative is so to the diagonal of
/// the square. Everything that the recipe does is periodic: mesh, noise, stress, adhesion. The same
/// on any number of threads.
///
/// Throws Error(request) for a recipe that asks for what a tile has not: a pattern that is so wide
/// against it that a crack would meet its own image, attributes, pictures, names of materials or
/// nodes. Throws Cancelled whenever the context cancels.
CrackedTile crack_tile(const Recipe& recipe, const TileSize& size, const Context& context);

}  // namespace craze
