// A square that continues on itself.
#pragma once

#include "craze/surface_mesh.h"

namespace craze {

/// The flat torus [0, period)² in z = 0 as cells × cells squares of two triangles each. Cells: 4 or
/// more, so that edges are shorter than half a period.
SurfaceMesh periodic_square(double period, int cells);

}  // namespace craze
