// The cracked mesh with everything that is known of it.
#pragma once

#include "craze/mesh/components.h"
#include "craze/mesh/surface_mesh.h"
#include "craze/model/simulation.h"
#include "craze/post/crack_schedule.h"

namespace craze {

/// The cut mesh with the attributes of `surface`, the mesh that the simulation started with, and
/// per vertex: crack_distance, along the surface to the nearest crack, the diagonal of the box
/// where there is none; crack_time, the load when that crack opened, and crack_growth, the time of
/// `schedule` when it came to its nearest point, both −1 where there is none; displacement, Eq. 9
/// with γ = 1 at the load that was reached. Per face: fragment, the part of the cut mesh;
/// source_face, the input's face. Attributes of these names that the surface already has are
/// replaced. Cracks are shut: see opened_surface.
SurfaceMesh output_surface(const SurfaceMesh& surface, const Simulation& simulation,
                           const CrackSchedule& schedule, const Components& fragments);

}  // namespace craze
