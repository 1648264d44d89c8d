// The cracked mesh as it is shown and written: shut, or opened as the recipe asks.
#pragma once

#include <string>
#include <vector>

#include "craze/mesh/surface_mesh.h"
#include "craze/model/simulation.h"
#include "craze/post/opening.h"
#include "craze/render/crack_lines.h"
#include "craze/scenario/recipe.h"

namespace craze {

struct ShownSurface {
  SurfaceMesh mesh;                   ///< with all attributes
  OpenedMesh opened;                  ///< where its faces and vertices come from
  bool shut = true;                   ///< the cracks are lines, not gaps
  std::vector<std::string> warnings;  ///< what could not be done as asked, a sentence each
};

/// `cut` is the cut mesh of the simulation, with the attributes that are to be shown.
ShownSurface shown_surface(SurfaceMesh cut, const Simulation& simulation,
                           const PostParameters& post);

/// The corner normals to draw it with: those of the mesh where it has some; else the smooth ones of
/// `surface`, which the simulation started with, so that neither cracks nor gaps leave a mark in
/// the shading beside them; walls are flat. Empty where the surface is curled and has to be shaded
/// as it is.
std::vector<Vec3> picture_normals(const ShownSurface& shown, const SurfaceMesh& surface,
                                  const Simulation& simulation, const PostParameters& post,
                                  double crease);

/// The cracks of the cut mesh as lines to draw on it, or as the worn edges of gaps.
render::CrackLines picture_lines(const ShownSurface& shown, const TriangleMesh& mesh, double reach);

}  // namespace craze
