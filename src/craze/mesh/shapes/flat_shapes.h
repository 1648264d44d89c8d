// Shapes with flat faces: rectangles and the cube.
#pragma once

#include <cstdint>

#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

struct RectangleOptions {
  int cells_x = 1, cells_y = 1;
  double size_x = 1, size_y = 1;
  double jitter = 0;  ///< 0 … 0.45: inner vertices move by at most this fraction of a cell per axis
  std::uint64_t seed = 1;
};

/// A rectangle in the plane z = 0, centred, facing +z, of 2 cells_x cells_y triangles. With
/// jitter = 0 it is the regular grid whose diagonals alternate like a chessboard, so that no
/// diagonal direction is preferred. With jitter the vertices of the border slide along it, the
/// corners stay, and each cell takes its Delaunay diagonal; a displacement that would flatten a
/// triangle is halved until it does not.
SurfaceMesh make_rectangle(const RectangleOptions& options, const Context& context);

/// A closed cube of 12 cells² triangles, centred; each side has its own place in UV space.
SurfaceMesh make_cube(int cells, double size, const Context& context);

}  // namespace craze
