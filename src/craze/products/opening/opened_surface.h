// The cracked surface as it is shown: shut, or opened as [post] asks.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/growth_times.h"
#include "craze/products/opening/opening.h"
#include "craze/surface_mesh.h"

namespace craze {

struct OpenedSurface {
  SurfaceMesh mesh;  ///< with all attributes
  /// Where its faces and vertices come from; without a mesh of its own where nothing was opened.
  OpenedMesh opened;
  /// What was opened instead of the result's cut mesh, since some faces of that were too large to
  /// bend (bend_refinement.h); mostly null.
  std::shared_ptr<const TriangleMesh> refined;
  GrowthTimes times;                  ///< of the mesh that was opened
  bool shut = true;                   ///< the cracks are lines, not gaps
  bool curled = false;                ///< its faces are bent
  std::vector<std::string> warnings;  ///< what could not be done as asked, a sentence each

  /// The mesh that was opened.
  const TriangleMesh& base(const Result& result) const;
};

/// `cut` is the result's cut mesh with the attributes that are to be shown (cut_surface.h), `times`
/// are the result's. The
/// result is not cracked again: any number of openings may be made of it. Throws Error(request) for
/// parameters that are negative or not finite, and Cancelled.
OpenedSurface opened_surface(const Result& result, SurfaceMesh cut, GrowthTimes times,
                             const PostParameters& post, const Context& context);

}  // namespace craze
