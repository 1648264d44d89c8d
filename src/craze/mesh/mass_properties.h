// Volume, centre of mass and inertia of a solid.
#pragma once

#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// Of density 1.
struct MassProperties {
  double volume = 0;            ///< length³; below 0 for a surface that looks inwards
  Vec3 centre = Vec3::Zero();   ///< of mass; of the vertices where there is no volume
  Mat3 inertia = Mat3::Zero();  ///< about the centre, length⁵: ∫ (r² − x xᵀ)
};

/// `triangles` close a solid. The integrals are exact but for rounding (Eberly, "Polyhedral Mass
/// Properties", 2002).
MassProperties mass_properties(const std::vector<Vec3>& positions,
                               const std::vector<Triangle>& triangles);

}  // namespace craze
