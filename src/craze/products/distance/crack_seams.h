// Cracks of a mesh that comes from a file, told from the seams of its textures and normals.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/products/distance/seams.h"
#include "craze/surface_mesh.h"

namespace craze {

enum class SeamKind {
  joined,  ///< one surface, whose vertices have copies for what differs: UVs, normals and so on
  crack,
  border,  ///< the surface ended there before it cracked
};

struct KnownSeam {
  SeamPiece piece;
  SeamKind kind;
};

/// seam_pieces(mesh) and what they are; `mesh` has the surface's triangles.
/// A run's vertex attributes tell. Along a crack crack_distance is 0. Copies that were made for a
/// texture have the same displacement, the two sides of a crack do not, but at its tips. Without
/// displacement a crack is where both sides look the same (UVs, normals, colours, attributes,
/// material and object), or where crack_distance at a corner opposite is the distance to the edge.
/// Without crack_distance, in files that keep UVs and normals apart from vertices (OBJ), all that
/// parts vertices is a crack, but for different objects and colours; elsewhere what nothing but a
/// cut explains. None where most triangles share no edge at all, as in files that repeat every
/// vertex.
std::vector<KnownSeam> known_seams(const SurfaceMesh& surface, const TriangleMesh& mesh);

/// Of seam_sides(mesh), those that are cracks by known_seams().
std::vector<std::int32_t> crack_seams(const SurfaceMesh& surface, const TriangleMesh& mesh);

}  // namespace craze
