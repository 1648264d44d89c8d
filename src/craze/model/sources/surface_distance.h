// Distance and direction along a surface from one of its points.
//
// References
// [MR12] Melvær, Reimers: Geodesic polar coordinates on polygonal meshes. Computer Graphics Forum
// 31(8), 2012.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// A point of a mesh's surface.
struct PointOnSurface {
  std::int32_t face = -1;  ///< −1: the mesh has no faces
  Vec3 position = Vec3::Zero();
  double distance = 0;  ///< straight, to the point asked for
};

/// The nearest point of the surface; of equally near ones that on the lowest face.
PointOnSurface closest_surface_point(const TriangleMesh& mesh, const Vec3& point,
                                     const Context& context);

/// The same, for a point that should lie on the surface. Throws Error(request), with `where` as its
/// place, if it is farther away than a tenth of the diagonal of the mesh's bounding box.
PointOnSurface require_surface_point(const TriangleMesh& mesh, const Vec3& point, const char* where,
                                     const Context& context);

/// Lengths of the shortest ways along the surface; infinity where there is none, or none within the
/// reach asked for.
struct SurfaceDistance {
  std::vector<double> vertex;  ///< #V
  std::vector<double> face;    ///< #F, at the centroids
  /// #F, unit, in each face's tangent_frame at its centroid, pointing away from the source; zero
  /// where `face` is 0 or infinite.
  std::vector<Vec2> direction;
};

/// Distances from `source` up to `reach`. Within 10⁻³ on flat and developable surfaces, elsewhere
/// about 1 % at 8,000 triangles, half of that at four times as many. Fronts spread from vertex to
/// vertex, each triangle unfolding the source behind it as a point [MR12], so long thin triangles
/// do no harm. Cost: O(#V log #V). Throws Cancelled.
SurfaceDistance surface_distance(const TriangleMesh& mesh, const PointOnSurface& source,
                                 const Context& context, double reach = 1e300);

}  // namespace craze
