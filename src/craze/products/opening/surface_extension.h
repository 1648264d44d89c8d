// Values known at some vertices, carried over the rest of the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// #V: `known` (#V) where is_known (#V, 0 or 1), elsewhere the solution of the screened Laplace
/// equation L = ℓ² ΔL with no flux over open edges. It fades from the known values to 0 over about
/// `length` (ℓ), whatever the size of the triangles; with a length far above the distance between
/// known vertices it is as smooth a surface through them as there is. Residual: `tolerance`,
/// relative.
std::vector<double> extend_over_surface(const TriangleMesh& mesh,
                                        const std::vector<std::uint8_t>& is_known,
                                        const std::vector<double>& known, double length,
                                        double tolerance = 1e-6);

}  // namespace craze
