// When each place starts to be loaded: evolution.onset_*.
#pragma once

#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/model/sources/input_fields.h"
#include "craze/parameters.h"

namespace craze {

/// #F, the load factor at which each face starts to be loaded, ≥ 0, ∞ included: the sum of what the
/// recipe gives of
///   the attribute, per face, a vertex attribute averaged over the corners;
///   the picture, 0 … 1, times max_load;
///   the front, how far a face's middle lies behind the place that the front meets first, over
///   onset_speed: along onset_direction, or in distance from onset_point, straight through space.
/// Empty where it gives none. Throws Error(request) as the functions of input_fields.h do, for a
/// negative onset, a front without a speed or on a tile, and where running_engine() is euler.
std::vector<double> onset_per_face(const TriangleMesh& mesh, const SimulationParameters& parameters,
                                   const InputFields& fields);

}  // namespace craze
