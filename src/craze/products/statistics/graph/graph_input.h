// What the statistics are computed from: lines on a surface, however they were obtained.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "craze/context.h"
#include "craze/line_set.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/crack_network.h"
#include "craze/surface_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// A straight piece from point a to point b. Left and right as seen from outside the surface.
struct GraphInputEdge {
  std::int32_t a = -1, b = -1;
  bool border = false;  ///< a piece of the surface's border, not a crack
  double time = std::numeric_limits<double>::quiet_NaN();  ///< when it opened; NaN: not known
  std::int32_t event = -1;        ///< the crack event, decides between equal times; −1: not known
  std::int32_t left_piece = -1;   ///< index into piece_areas; −1: not known
  std::int32_t right_piece = -1;  ///< likewise
};

/// Edges meet only at points; points are distinct.
struct CrackGraphInput {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;  ///< one per point, unit, outward
  std::vector<GraphInputEdge> edges;
  double surface_area = 0;          ///< 0: not known
  std::vector<double> piece_areas;  ///< area of each fragment; empty: not known
  double metres_per_unit = 0;       ///< of the points; 0: not known
};

/// A rectangle in a plane through which a planar pattern is seen.
struct Window {
  Mat32 frame;  ///< orthonormal; a point's plane coordinates are frameᵀ p
  Vec2 low, high;
  bool drawn = false;  ///< its sides are border edges of the input

  double area() const { return (high - low).prod(); }
};

/// The window of a planar input: the rectangle its border edges draw, or, where it has none, the
/// bounding box of its points in the plane. None for a curved input or another border.
std::optional<Window> find_window(const CrackGraphInput& input);

/// How near lines have to end to meet, of the diagonal of the box around them.
inline constexpr double meeting_distance = 1e-6;

/// Lines from a file. Points nearer than the meeting distance are one, repeated edges too, and
/// diagonals that a pixel skeleton has beside two straight steps go. Reads the edge
/// attributes "time", "event" and "border" (non-zero: border) and the point attribute "normal"
/// (three components). Without normals the lines must lie in a plane (within 10⁻³ of their extent),
/// else Error(request); its normal is taken with positive z (or y, or x, where z vanishes).
CrackGraphInput graph_from_lines(const LineSet& lines);

/// A finished run: its cracks, with the border and the fragments of the mesh that it cut.
CrackGraphInput graph_from_network(const CrackNetwork& network, const TriangleMesh& cut_mesh);

/// A cracked mesh from a file. An open edge that lies on another is a crack or a seam of textures,
/// as known_seams() tells (distance/crack_seams.h); one by itself is border. Reads the vertex
/// attribute "crack_time" (an edge opened at the later time of its ends). Meshes whose cracks were
/// opened into gaps have no such edges: give their lines instead. Throws what repair() does.
CrackGraphInput graph_from_cut_mesh(const SurfaceMesh& mesh, const Context& context = {});

}  // namespace craze
