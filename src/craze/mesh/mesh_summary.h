// What a surface is, in a few numbers.
#pragma once

#include <cstdint>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// Lengths in model units. Everything is 0 for a mesh without faces.
struct MeshSummary {
  std::int32_t vertices = 0;  ///< those that have faces
  std::int32_t faces = 0;
  std::int32_t components = 0;  ///< parts not joined by an edge
  std::int32_t boundary_loops = 0;
  std::int32_t euler_characteristic = 0;  ///< vertices − edges + faces
  std::int32_t genus = -1;  ///< summed over the components; −1 where there is a boundary
  double area = 0;
  double volume = 0;  ///< enclosed, positive if oriented outward; 0 where there is a boundary
  double edge_min = 0, edge_mean = 0, edge_max = 0;
  double diagonal = 0;      ///< of the axis-aligned box
  double worst_aspect = 0;  ///< largest of longest edge / height over it, 2/√3 for equilateral

  bool closed() const { return faces > 0 && boundary_loops == 0; }
};

MeshSummary summarize(const TriangleMesh& mesh);

/// Longest edge over the height upon it: 2/√3 for an equilateral triangle, infinite without area.
double aspect_ratio(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace craze
