// How a sample's surface and its cracks look, by a plan's values.
#pragma once

#include <cstdint>

#include "craze/job/plan/plan.h"
#include "craze/material/material.h"

namespace craze {

/// The material that `surface` and `lines` ask for. `name` seeds what is not in the plan: which way
/// bricks and veins run, where patches and clouds lie.
render::Material surface_material(const PlanValues& values, std::uint64_t name);

}  // namespace craze
