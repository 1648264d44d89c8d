// Adhesion of the layer to what lies under it, and the length over which a crack unloads it.
#pragma once

#include "craze/model/parameters.h"

namespace craze {

/// κ = 1/ℓ², 1/length²: the force that holds a node back per area and displacement, in units of the
/// layer's stiffness. 0 without adhesion. Equilibrium then solves div σ = κ u, whose solutions
/// decay over ℓ (Cox's shear-lag film).
double adhesion(const LayerParameters& layer);

/// ℓ in length units: as given, or derived from the asked-for spacing; 0: no adhesion.
double screening_length(const LayerParameters& layer);

/// Length around a crack tip in which no intact node fails (failure_criterion.h): as given, else
/// half of ℓ.
double process_zone(const MaterialParameters& material, const LayerParameters& layer);

}  // namespace craze
