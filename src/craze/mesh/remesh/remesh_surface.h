// What the steps of remeshing work on: the mesh as it stands, the input, and what is wanted where.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/random.h"
#include "craze/mesh/closest_point.h"
#include "craze/mesh/edit_mesh.h"
#include "craze/mesh/remesh/remesh.h"
#include "craze/mesh/remesh/remesh_progress.h"
#include "craze/mesh/remesh/surface_walk.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// Edges longer and shorter than these parts of the length wanted are split and collapsed.
inline constexpr double too_long = 4.0 / 3, too_short = 4.0 / 5;

/// (b − a) × (c − a), length²: along the normal of the triangle, twice its area long.
inline Vec3 cross_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a);
}

struct RemeshSurface {
  /// Throws Error where the mesh would have more triangles than anything could use.
  RemeshSurface(const SurfaceMesh& input, const TriangleMesh& topology,
                const RemeshOptions& options, RemeshProgress& progress);

  /// Length of a half-edge.
  double edge_length(std::int32_t h) const;
  /// For every edge, face or vertex looked at in a loop: throws Cancelled (remesh_progress.h).
  void step() const { progress.step(mesh.face_slots()); }
  /// The length wanted between two neighbours.
  double wanted_length(std::int32_t v, std::int32_t w) const {
    return 0.5 * (wanted[v] + wanted[w]);
  }
  /// cross_of the corners of a face.
  Vec3 face_cross(std::int32_t f) const;
  /// Splits an edge at a point; returns the new vertex.
  std::int32_t split(std::int32_t h, const Vec3& at);
  /// The faces around a vertex have changed: their edges may want a flip.
  void look_around_again(std::int32_t v);
  /// The same of one face, and of all.
  void look_at_again(std::int32_t f);
  void look_everywhere_again();

  const SurfaceMesh& input;
  const RemeshOptions& options;
  RemeshProgress& progress;
  Random variation, place, shaking;  ///< independent streams of the seed
  double max_distance;               ///< from the input, length
  std::vector<double> lengths;       ///< #V of the input: the length wanted there
  std::vector<char> marks;           ///< 3 #F of the input: what line its edge lies on
  std::vector<std::int32_t> patch;   ///< #F of the input: faces between the same seams
  ClosestPoint tree;                 ///< of the input
  SurfaceWalk walk;                  ///< on the input
  EditMesh mesh;
  std::vector<double> length;      ///< #V: the length wanted at the vertex,
  std::vector<double> wanted;      ///< and with its random variation
  std::vector<std::int32_t> near;  ///< #V: an input face near the vertex
  std::vector<double> line_error;  ///< #V: how far thinning may have moved its marked line
  /// 3 #F: 0 where, since the faces beside it changed, the halfedge's edge was found to want no
  /// flip, to be not too long, or to be not too short; else 1.
  std::vector<char> may_flip, may_be_long, may_be_short;

 private:
  void refuse_too_many(const TriangleMesh& topology) const;
  void add_vertex(double length_there, std::int32_t near_face);
};

}  // namespace craze
