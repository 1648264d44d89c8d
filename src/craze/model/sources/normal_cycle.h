// The curvature measure of a triangle mesh around a point.
//
// References
// [CSM03] Cohen-Steiner, Morvan: Restricted Delaunay triangulations and normal cycle. SoCG 2003.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// Integrals over the part of a mesh near a point c, each point x weighted with
/// w(x) = (1 − |x − c|²/R²)² inside the ball of radius R and 0 outside.
struct CurvatureMeasure {
  Sym3 tensor;      ///< Σ_e β(e) ∫_e w  ē ēᵀ, length: the curvature lies *across* ē
  double area = 0;  ///< ∫ w dA
  Vec3 normal = Vec3::Zero();  ///< ∫ w n dA
};

/// The normal cycle of a mesh: one signed dihedral angle per edge, positive where the surface is
/// convex seen from outside, none on borders. Keeps a reference to the mesh, which must not change.
class NormalCycle {
 public:
  /// Marks of one walk, so that walks in several threads do not meet. Give each thread its own.
  struct Scratch {
    std::vector<std::uint32_t> stamp;  // #F, the walk that last met the face
    std::vector<std::int32_t> queue;
    std::uint32_t walk = 0;
  };

  explicit NormalCycle(const TriangleMesh& mesh);

  /// The measure of the ball around `center`, restricted to the faces that hang together inside it
  /// with one of `seeds`: the far side of a thin wall does not count.
  CurvatureMeasure measure(const Vec3& center, double radius, std::span<const std::int32_t> seeds,
                           Scratch& scratch) const;

  /// Unit; zero for a face without area.
  const Vec3& face_normal(std::int32_t f) const { return normals_[f]; }

 private:
  /// One side of a face. Each edge is met from both of its sides, so each has half of its angle.
  struct Edge {
    Vec3 unit = Vec3::Zero();
    double length = 0, half_angle = 0;
  };

  const TriangleMesh& mesh_;
  std::vector<Vec3> normals_;  // #F
  std::vector<Edge> edges_;    // 3 #F
};

}  // namespace craze
