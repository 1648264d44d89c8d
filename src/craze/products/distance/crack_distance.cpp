#include "craze/products/distance/crack_distance.h"

#include "craze/base/segment_distance.h"

namespace craze {

double crack_distance(const NearbyCracks& cracks, std::int32_t f, const Vec3& point) {
  double nearest = cracks.max_distance;
  for (const NearbyCrack& s : cracks.of(f)) {
    nearest = std::min(nearest, point_segment_distance(point, s.a, s.b));
  }
  return nearest;
}

std::vector<double> crack_distances(const TriangleMesh& mesh, const NearbyCracks& cracks) {
  std::vector<double> distance(mesh.vertex_count(), cracks.max_distance);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    for (const std::int32_t v : mesh.triangle(f)) {
      distance[v] = std::min(distance[v], crack_distance(cracks, f, mesh.position(v)));
    }
  }
  // Unfolding rounds; the vertices of the cracks are sources.
  for (const NearbyCrack& s : cracks.segments) {
    distance[mesh.from(s.halfedge)] = distance[mesh.to(s.halfedge)] = 0;
  }
  return distance;
}

std::vector<double> crack_distances(const TriangleMesh& mesh, double max_distance,
                                    const Context& context) {
  return crack_distances(mesh, nearby_cracks(mesh, crack_sides(mesh), max_distance, context));
}

}  // namespace craze
