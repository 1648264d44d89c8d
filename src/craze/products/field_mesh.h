// The state of a run as a mesh with attributes, for files and for checks from outside.
#pragma once

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The mesh as it is cut now, all fields at the load that was reached (Simulation::load_on_field).
/// Face attributes s_xx s_yy s_zz s_xy s_yz s_zx: σ in world axes; s1 s2: its principal values,
/// the larger first; dx dy dz: the unit direction of s1.
/// Vertex attributes fx fy fz: F; v: v⁺ of the separation tensor without the residual of Eq. 8, 0
/// where it is negative; nx ny nz: n̂⁺; v2: the tensor's trace less v⁺, its other value where the
/// surface is flat; r: the residual's v⁺, at tips that are about to run on; ux uy uz: the
/// accumulated virtual displacement; k1 k2: the principal curvatures of the cut surface over
/// stress.curvature_radius. Throws Cancelled.
SurfaceMesh field_mesh(const Result& result, const Context& context);

}  // namespace craze
