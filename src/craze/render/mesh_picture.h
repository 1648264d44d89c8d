// A picture of a mesh from a file.
#pragma once

#include "craze/context.h"
#include "craze/render/picture.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The mesh with its shut cracks as lines: open edges that lie on each other without sharing their
/// vertices and are no seams (products/distance/crack_seams.h). Throws what repair() and
/// render_picture() throw.
render::Image mesh_picture(const SurfaceMesh& mesh, const render::PictureOptions& options,
                           const Context& context);

}  // namespace craze
