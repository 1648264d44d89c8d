// Preference of cracks for principal curvature directions [IO06 Fig. 2].
#pragma once

#include <span>
#include <vector>

#include "craze/model/sources/curvature.h"
#include "craze/tensor.h"

namespace craze {

/// Which way cracks should run at a node, and how sure the shape is of it.
struct PreferredDirection {
  Vec3 along = Vec3::UnitX();  ///< unit, tangent: the direction of the smaller |κ|
  double confidence = 0;       ///< 0 … 1
};

/// #V. Cracks are to run along folds and limbs, as in the figure: along the direction of the
/// smaller |κ|. The confidence is (|κ_a| − |κ_b|)/(|κ_a| + |κ_b|), 0 at umbilics and 1 on a
/// cylinder, times κ²/(κ² + κ̄²) with κ the Frobenius norm and κ̄ its mean over the vertices: where
/// the surface is nearly flat its directions are noise.
std::vector<PreferredDirection> preferred_directions(std::span<const PrincipalCurvature> curvature);

/// ς′ = S ς S, S = I − (1 − √(1 − bias · confidence)) t tᵀ, t = along: forces along t count for
/// less, so cracks across t are rarer. bias 0 … 1: 0 returns ς; 1, with full confidence, leaves
/// only cracks along t. The largest eigenvalue never grows, and stays as it is where ς is isotropic
/// in the tangent plane: bias turns cracks and does not start them.
Sym3 bias_direction(const Sym3& separation, const PreferredDirection& preferred, double bias);

}  // namespace craze
