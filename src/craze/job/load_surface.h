// The surface a run works on: a file or a shape.
#pragma once

#include <string>

#include "craze/context.h"
#include "craze/read_mesh.h"

namespace craze {

/// Reads a mesh file, or makes the shape of "shape:NAME?key=value&…". Throws Error(input) for a
/// file that cannot be read, Error(usage) for an unknown shape, and Cancelled.
MeshFile load_surface(const std::string& input, const Context& context = {});

}  // namespace craze
