// Solids of revolution with triangles of about one size.
#pragma once

#include <vector>

#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

/// A smooth stretch of a profile in the half-plane (radius, z), as a dense polyline. The outward
/// side is on the right of the direction of travel. Two stretches meet in a sharp corner.
using ProfileStretch = std::vector<Vec2>;

/// The points of a circular arc about `center`; angles in radians, from +radius towards +z.
ProfileStretch arc(const Vec2& center, double radius, double from_angle, double to_angle);

/// The points of the cubic Bézier curve.
ProfileStretch bezier(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// Turns the profile about the z axis. Each ring takes as many vertices as its own circumference
/// asks for, so that edges are about `edge` long everywhere, at the axis too. The surface is closed
/// if the profile starts and ends on the axis (radius 0) or is itself closed (`loop`: the last
/// point equals the first). UVs: u about the axis, v along the profile. Corner normals are those
/// of the smooth surface.
SurfaceMesh revolve(const std::vector<ProfileStretch>& profile, double edge, const Context& context,
                    bool loop = false);

}  // namespace craze
