#include "craze/products/solids/room_inside.h"

#include <cmath>

#include "craze/base/parallel.h"
#include "craze/mesh/closest_point.h"

namespace craze {

namespace {

/// Of the distance to what lies opposite: a tenth is left between two inner surfaces.
constexpr double share_of_room = 0.9;
/// Faces whose normals have at least this cosine with the way in lie opposite.
constexpr double opposite_cosine = 0.2;
constexpr int most_steps = 30;
constexpr double tolerance = 1e-6;

/// The largest depth ≤ `depth` for which no face that looks the other way is nearer to the point
/// so deep below p than depth / share_of_room. A ball shrinks until it holds none (Ma, Bae and
/// Choi, "3D medial axis point approximation using nearest neighbors and the normal field", 2012).
double room_below(const ClosestPoint& surface, const Vec3& p, const Vec3& outwards, double depth) {
  const double mitre = outwards.norm();
  if (!(mitre > 0)) return depth;
  ClosestPoint::Filter filter;
  filter.normal = -outwards / mitre;
  filter.least = opposite_cosine;
  for (int step = 0; step < most_steps; ++step) {
    const Vec3 centre = p - depth * outwards;
    const double radius = depth / share_of_room;
    filter.farthest = radius;
    const ClosestPoint::Hit hit = surface.find(centre, filter);
    if (hit.face < 0 || hit.distance >= radius * (1 - tolerance)) return depth;
    // The depth at which the ball touches what was found: |w + d m|² = (d / share)².
    const Vec3 w = hit.point - p;
    const double a = 1 / (share_of_room * share_of_room) - mitre * mitre, b = -w.dot(outwards);
    const double root = b * b + a * w.squaredNorm();
    const double less = w.squaredNorm() / (b + std::sqrt(std::max(root, 0.0)));
    if (!(less < depth) || !(less > 0)) return depth / 2;
    filter.hint = hit.face;
    depth = less;
  }
  return depth;
}

}  // namespace

std::vector<double> room_inside(const TriangleMesh& mesh, const std::vector<Vec3>& outwards,
                                double thickness, const Context& context) {
  constexpr std::size_t vertices_per_chunk = 512;
  std::vector<double> room(mesh.positions().size(), thickness);
  const ClosestPoint surface(mesh.positions(), mesh.triangles());
  context.check();
  parallel_for(context.threads, room.size(), vertices_per_chunk,
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t v = begin; v < end; ++v) {
                   room[v] = room_below(surface, mesh.positions()[v], outwards[v], thickness);
                 }
               });
  return room;
}

}  // namespace craze
