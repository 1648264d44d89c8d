// Marks that are no cracks, strewn over what a picture shows.
#pragma once

#include <vector>

#include "craze/job/dataset/scene/projection.h"
#include "craze/job/plan/plan.h"
#include "craze/render/material/marks.h"
#include "craze/render/rays/ray_scene.h"
#include "craze/surface_mesh.h"

namespace craze {

/// As many of each kind as the values say, where rays through random places of the picture meet the
/// mesh; their sizes go with the picture's pixels. Model units. `lamp` is the unit vector towards
/// the lamp.
std::vector<render::Mark> strewn_marks(const PlanValues& values, const SurfaceMesh& mesh,
                                       const render::RayScene& rays, const Projection& projection,
                                       const render::Rgb& color, const Vec3& lamp,
                                       std::uint64_t seed);

}  // namespace craze
