// Adhesion of the layer to what lies under it, and the length over which a crack unloads it.
#pragma once

#include "craze/parameters.h"

namespace craze {

/// The parameters with everything relative made absolute, for an object of that diagonal:
/// layer.spacing from relative_spacing, layer.screening_length ℓ from the spacing (at the load
/// max_load), stress.noise_length, material.scatter_length, lookahead and toughness from their
/// relative_ keys; without adhesion, where √ℓ says nothing, the toughness stays as given. What is
/// absolute already stays.
SimulationParameters resolve_lengths(SimulationParameters parameters, double diagonal);

/// Mean spacing √Ā of the cracks over ℓ, after loading up to max_load times the strength. A strip
/// splits while it is longer than L = 2ℓ arccosh(1/(1 − 1/s)); cells in two dimensions were
/// measured at 0.66 L, at loads from 1.5 to 4 within 4 %. Cracks start at weak places, so that
/// scatter brings them closer; healing takes some of the old cracks out of the pattern. Of the
/// toughness the spacing depends by less than 6 %.
double spacing_per_screening_length(const SimulationParameters& parameters);

/// κ = 1/ℓ², 1/length²: the force that holds a node back per area and displacement, in units of the
/// layer's stiffness. 0 without adhesion. Equilibrium then solves div σ = κ u, whose solutions
/// decay over ℓ (Cox's shear-lag film). Wants resolved parameters, as all of these do.
double adhesion(const LayerParameters& layer);

/// Length around a crack tip in which no intact node fails (failure_criterion.h): as given, else
/// half of ℓ.
double process_zone(const MaterialParameters& material, const LayerParameters& layer);

}  // namespace craze
