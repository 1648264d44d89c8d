// Makes any triangles into a surface that can be simulated.
#pragma once

#include <cstdint>
#include <string>

#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

struct RepairOptions {
  /// Vertices closer than this times the diagonal of the box are merged, and triangles lower than
  /// it are dropped. Negative: vertices stay apart and only triangles without any height go.
  double tolerance = 1e-9;
};

/// What was found and done. All counts; components and boundary loops are those of the result.
struct RepairReport {
  std::int32_t merged_vertices = 0;
  std::int32_t unused_vertices = 0;   ///< dropped: no face uses them, or no longer
  std::int32_t degenerate_faces = 0;  ///< dropped: a repeated corner, or no height
  std::int32_t duplicate_faces = 0;   ///< dropped: the same three corners, or a fin
                                      ///< of two sides (duplicate_faces.h)
  std::int32_t flipped_faces = 0;
  std::int32_t nonmanifold_edges = 0;  ///< with more than two faces
  std::int32_t cut_edges = 0;          ///< opened: a face too many, or no consistent orientation
  std::int32_t split_vertices = 0;     ///< copies made of vertices with several fans
  std::int32_t inserted_vertices = 0;  ///< on edges that would coincide with another by their ends
  std::int32_t components = 0;
  std::int32_t boundary_loops = 0;

  /// True if the input had to be touched; merged and unused vertices alone do not count.
  bool defects() const {
    return degenerate_faces + duplicate_faces + flipped_faces + nonmanifold_edges + cut_edges +
               split_vertices + inserted_vertices >
           0;
  }
  /// "merged 3 vertices, flipped 1 face, …", empty if nothing was done.
  std::string text() const;
};

/// Merges vertices that coincide (a seam is then one vertex; corner UVs and normals keep their two
/// sides), drops degenerate and duplicate faces, orients each part consistently and outward where
/// it is closed, cuts apart edges with too many faces and vertices with several fans. On the result
/// the constructor of TriangleMesh succeeds, and every attribute is carried: a merged vertex keeps
/// those of the first, a copy those of its original. source_faces is filled with the triangle's
/// number if it was empty. The result has no faces if none was sound.
/// Throws Error(input) for positions that are not finite or beyond 1e50, corners that are not
/// vertices, and attributes of the wrong length, and Cancelled. Deterministic; O(#F log #F).
SurfaceMesh repair(const SurfaceMesh& input, const RepairOptions& options, RepairReport& report,
                   const Context& context = {});

}  // namespace craze
