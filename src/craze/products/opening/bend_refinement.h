// Faces that are too large to bend, made smaller.
#pragma once

#include <memory>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// Error of a curled surface that is refined for its curl, as a share of the lift at the cracks: a
/// lift that fades as exp(−x/ℓ) is drawn by straight lines over edges of length h to h²/8ℓ² of it.
inline constexpr double bend_tolerance = 0.05;

/// From the cracks: farther away such a lift is below bend_tolerance.
double bend_reach(double length);

/// The mesh with every edge near cracks short enough for a lift that fades over `length` (ℓ) to be
/// drawn within bend_tolerance. Sides of cracks stay whole, and where one is longer than that, so
/// may be the shorter edges beside it. crack_distance: #V, length; where the lift is below
/// bend_tolerance nothing is split. Vertices keep their numbers, faces are parts of those of the
/// same number (source_face) with the others after them. Null: nothing had to be split.
std::shared_ptr<const TriangleMesh> refined_to_bend(const TriangleMesh& mesh,
                                                    std::vector<double> crack_distance,
                                                    double length);

}  // namespace craze
