// post.late_width in the mesh: later cracks open less.
#pragma once

#include <vector>

#include "craze/engine/width_by_age.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"

namespace craze {

/// #V: `displacement` (#V), but both sides of a crack part by the factor of its age (crack_times:
/// by TriangleMesh::crack_of). Along a crack the factor goes from edge to edge without a step;
/// where cracks meet each keeps its own, and together they move as the oldest does. From the cracks
/// the factor goes over into 1 within the pieces, so that what lies beside a rim moves with it.
std::vector<Vec3> aged_displacement(const TriangleMesh& mesh, const CrackSites& sites,
                                    const std::vector<Vec3>& displacement,
                                    const std::vector<double>& crack_times,
                                    const WidthByAge& width);

}  // namespace craze
