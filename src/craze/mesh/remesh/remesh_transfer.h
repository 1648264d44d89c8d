// Attributes of a remeshed surface, read off the input at the nearest points.
#pragma once

#include "craze/context.h"
#include "craze/mesh/remesh/remesh_surface.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The mesh's faces as a surface, with every attribute of the input. Throws Cancelled.
SurfaceMesh transfer_attributes(const RemeshSurface& remeshed, const Context& context);

}  // namespace craze
