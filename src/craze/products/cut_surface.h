// The cracked mesh with everything that is known of it.
#pragma once

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/products/growth/growth_times.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The cut mesh with the attributes of the surface that it was cut out of, and
/// per vertex: crack_distance, along the surface to the nearest crack, the diagonal of the box
/// where there is none; crack_time, the load when that crack opened, and crack_growth, the time of
/// the clip (crack_schedule.h) when it came to its nearest point, both −1 where there is none;
/// displacement, Eq. 9 with γ = 1 at the load that was reached. Per face: fragment, the part of the
/// cut mesh; source_face, the input's face. Attributes of these names that the surface already has
/// are replaced. Cracks are shut: see opening/opened_surface.h. Throws Cancelled.
SurfaceMesh cut_surface(const Result& result, const GrowthTimes& times, const Context& context);

/// The cut mesh with the attributes of the surface that it was cut out of alone.
SurfaceMesh plain_cut_surface(const Result& result, const Threads& threads);

}  // namespace craze
