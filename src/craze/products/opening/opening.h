// Gaps, side walls and curl: section 5 of the paper.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/surface_mesh.h"

namespace craze {

struct OpeningOptions {
  double gap = 0;            ///< γ of Eq. 9; 0: the cracks stay shut
  double wall = 0;           ///< depth of the side walls, length; 0: none
  double curl = 0;           ///< lift of the crack's edges over their displacement; below 0: down
  double curl_length = 0;    ///< how far the lift reaches inwards; 0: by the spacing of the cracks
  bool border_wall = true;   ///< walls along the border of the input too: a sheet becomes a slab
  bool keep_border = false;  ///< border vertices that are on no crack stay where they are
  std::vector<double> chip_depth = {};  ///< #V, length: how deep chips are there; empty: none
};

/// How an opened mesh whose fragments are closed solids is put together (solids/solids.h): outer
/// surfaces, walls, inner surfaces, cores.
struct SolidParts {
  std::int32_t inner_begin;        ///< faces from here on are inner surfaces
  std::int32_t core_begin;         ///< faces from here on are of cores
  std::int32_t core_vertex;        ///< vertices from here on are of cores
  std::vector<std::int32_t> core;  ///< of each face of cores: of which, from 0
};

/// A point of a wall in rows (faces/rough_faces.h): on the way between a top and a bottom of the
/// wall, moved aside.
struct WallPoint {
  std::int32_t top, bottom;  ///< vertices of the opened mesh
  double share;              ///< of the way
  Vec3 aside;

  Vec3 between(const std::vector<Vec3>& positions) const {
    return positions[top] + share * (positions[bottom] - positions[top]);
  }
};

/// The cut mesh, opened. Attributes are for the caller to carry over by the two maps.
struct OpenedMesh {
  /// Positions, triangles, face_materials: 0 = "crack_wall" for side walls, −1 otherwise. The faces
  /// and vertices of the simulation mesh come first, in its order.
  SurfaceMesh mesh;
  std::vector<std::int32_t> vertex_of;  ///< #V: the simulation vertex
  std::vector<std::int32_t> face_of;    ///< #F: the simulation face, −1 for walls
  std::vector<std::int32_t> beside;     ///< #F: that face, or the one that a wall hangs from
  std::vector<Vec3> chipped;            ///< #V of the simulation mesh: moved by chips; empty: none
  std::optional<SolidParts> solid;      ///< none: a surface
  std::vector<WallPoint> wall_points;   ///< the last vertices; none: walls are flat
  /// Where the surface would have passed through itself it was opened less.
  std::int32_t limited_vertices = 0;  ///< of the simulation mesh
  double least_share = 1;             ///< of the opening asked for
  std::int32_t folded_faces = 0;      ///< faces turned over all the same
  std::int32_t crossings = 0;         ///< pairs of triangles that cross all the same
};

/// `displacement` (#V): the accumulated virtual displacement u of each vertex, world axes. The
/// result is closed, by index, wherever the input of the simulation was. Throws Error(request) if
/// the arrays do not fit or an option is negative or not finite, and Cancelled.
OpenedMesh open_cracks(const TriangleMesh& mesh, const std::vector<Vec3>& displacement,
                       const OpeningOptions& options, const Context& context);

}  // namespace craze
