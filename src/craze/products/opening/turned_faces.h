// Faces that turn over as the cracks open.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// Faces of the mesh, ascending, that look the other way with their vertices at `positions` (#V),
/// or have an edge that points back: a piece that has shrunk through its middle is turned about it,
/// in its own plane.
std::vector<std::int32_t> turned_faces(const TriangleMesh& mesh,
                                       const std::vector<Vec3>& positions);

/// Whether face f is one of them.
bool is_turned(const TriangleMesh& mesh, const std::vector<Vec3>& positions, std::int32_t f);

/// `shift` (#V), but faces that it would turn over move as one, by the mean of their vertices'
/// shifts, of those on hard edges or at corners alone where there are any: needles beside a crack,
/// which its rims would overtake. So what is wider than a needle opens all the way. Where more than
/// a hundredth of the faces would turn, it is not about needles, and the shifts come back as they
/// are. `before` (#V, or none): shifts that are made first, and stand.
std::vector<Vec3> needles_moved_as_one(const TriangleMesh& mesh, std::vector<Vec3> shift,
                                       const std::vector<Vec3>& before = {});

}  // namespace craze
