// Distance along the surface to the nearest crack.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/products/distance/nearby_cracks.h"

namespace craze {

/// Distance from a point of face f to the nearest crack, in model units; max_distance of `cracks`
/// where none is that near. Exact inside the face, not interpolated between its corners.
double crack_distance(const NearbyCracks& cracks, std::int32_t f, const Vec3& point);

/// #V: the same per vertex; 0 on the cracks themselves.
std::vector<double> crack_distances(const TriangleMesh& mesh, const NearbyCracks& cracks);

/// #V, from the mesh alone.
std::vector<double> crack_distances(const TriangleMesh& mesh, double max_distance,
                                    const Context& context);

}  // namespace craze
