// Shapes with curved faces. `edge` is the edge length asked for, about uniform over the surface.
#pragma once

#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

/// A flat disc facing +z.
SurfaceMesh make_disc(double radius, double edge, const Context& context);

/// A geodesic sphere: an icosahedron whose sides are split into frequency² triangles.
SurfaceMesh make_sphere(double radius, int frequency, const Context& context);

/// A tube along z, with flat ends unless `open`.
SurfaceMesh make_cylinder(double radius, double height, bool open, double edge,
                          const Context& context);

/// A ring about z: the tube of radius `minor` follows a circle of radius `major`.
SurfaceMesh make_torus(double major, double minor, double edge, const Context& context);

/// A half sphere with a wall and a rounded lip.
SurfaceMesh make_bowl(double radius, double wall, double edge, const Context& context);

/// A Japanese tea cup without a handle: foot ring, rounded lower body, steep side, rounded lip. It
/// stands on z = 0; `radius` is taken at the lip.
SurfaceMesh make_cup(double radius, double height, double wall, double edge,
                     const Context& context);

}  // namespace craze
