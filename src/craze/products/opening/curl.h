// Curling edges, as of drying mud or peeling paint.
#pragma once

#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"

namespace craze {

/// #V: how far each vertex is lifted along its normal. `edge_lift` (#V) is taken at vertices on
/// cracks; from there the lift fades towards the inside of the pieces by the screened Laplace
/// equation L = ℓ² ΔL, over about `length` (ℓ), so it does not depend on the size of the triangles.
std::vector<double> curl_lift(const TriangleMesh& mesh, const CrackSites& sites,
                              const std::vector<double>& edge_lift, double length);

/// How far a lift reaches, by the mean distance between cracks: a third of it.
inline double curl_length(double crack_distance) {
  return crack_distance / 3;
}

/// A third of the mean distance between cracks, 2 × area / crack length; 0 without cracks.
double natural_curl_length(const TriangleMesh& mesh, const CrackSites& sites);

}  // namespace craze
