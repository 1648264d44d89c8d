// The initial stress field σ₀ [IO06 §3.2, §4.1].
//
// References
// [IO06] Iben, O'Brien: Generating Surface Crack Patterns. SCA 2006.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/sources/input_fields.h"
#include "craze/parameters.h"
#include "craze/tensor.h"

namespace craze {

/// #F, in each face's tangent_frame, tension positive:
///   σ₀ = texture · max(0, 1 + noise ξ) · (uniform I + Eᵀ T E + curvature κ + attribute + impacts),
/// ξ a random field of mean 0 and standard deviation 1. A face without area gets zero. Throws
/// Error(request) for an impact far from the surface, an unknown attribute, a texture without UVs,
/// or more than 10⁹ triangles times impacts; and Cancelled.
std::vector<Sym2> initial_stress(const TriangleMesh& mesh, const StressParameters& stress,
                                 std::span<const Impact> impacts, std::uint64_t seed,
                                 const InputFields& fields, const Context& context);

/// Adds the field of one impact to `sigma` (#F). Along the surface at distance r from the nearest
/// surface point, with r̂ pointing away from it and t̂ across:
///   radial w_r(r) r̂ r̂ᵀ + hoop w_t(r) t̂ t̂ᵀ,  w(r) = 1 up to the radius, (radius / r)^falloff
///   beyond.
/// In the face that is hit, where directions mean nothing, the mean of both amplitudes, isotropic.
/// `where` names the impact in messages.
void add_impact(std::vector<Sym2>& sigma, const TriangleMesh& mesh, const Impact& impact,
                const char* where, const Context& context);

}  // namespace craze
