#include "craze/products/distance/nearby_cracks.h"

#include <algorithm>

#include "craze/base/segment_distance.h"
#include "craze/mesh/components.h"
#include "craze/products/distance/face_spread.h"

namespace craze {

namespace {

/// Unit vector in the plane of the face of h, perpendicular to h and pointing into the face.
Vec3 into_face(const TriangleMesh& mesh, std::int32_t h, const Vec3& along) {
  const Vec3 side = mesh.position(mesh.from(TriangleMesh::prev(h))) - mesh.position(mesh.from(h));
  const Vec3 across = side - side.dot(along) * along;
  const double length = across.norm();
  return length > 1e-12 * side.norm() ? Vec3(across / length) : Vec3(along.unitOrthogonal());
}

/// How crack edges go over the faces in space.
class Propagation {
 public:
  using Carried = NearbyCrack;

  Propagation(const TriangleMesh& mesh, double max_distance, const CrackVisit& visit)
      : mesh_(mesh), max_distance_(max_distance), visit_(visit) {}

  NearbyCrack source(std::int32_t h) const {
    return {mesh_.position(mesh_.from(h)), mesh_.position(mesh_.to(h)), h};
  }

  std::int32_t number(const NearbyCrack& crack) const { return crack.halfedge; }

  bool matters(std::int32_t, double distance, double covered, const NearbyCrack&) const {
    return distance <= max_distance_ && distance <= covered;
  }

  /// The distance to a segment is convex, so over the face it is largest at a corner.
  double farthest(std::int32_t f, const NearbyCrack& crack) const {
    double largest = 0;
    for (const std::int32_t v : mesh_.triangle(f)) {
      largest = std::max(largest, point_segment_distance(mesh_.position(v), crack.a, crack.b));
    }
    return largest;
  }

  double distance_to_edge(std::int32_t h, const NearbyCrack& crack) const {
    return coplanar_segment_distance(crack.a, crack.b, mesh_.position(mesh_.from(h)),
                                     mesh_.position(mesh_.to(h)));
  }

  NearbyCrack across(std::int32_t h, const NearbyCrack& crack) const {
    const Vec3& origin = mesh_.position(mesh_.from(h));
    const Vec3 along = (mesh_.position(mesh_.to(h)) - origin).normalized();
    const Vec3 in = into_face(mesh_, h, along), out = -into_face(mesh_, mesh_.opposite(h), -along);
    const auto unfold = [&](const Vec3& p) -> Vec3 {
      const Vec3 d = p - origin;
      return origin + d.dot(along) * along + d.dot(in) * out;
    };
    return {unfold(crack.a), unfold(crack.b), crack.halfedge};
  }

  void accept(std::int32_t face, const NearbyCrack& crack) { visit_(face, crack); }

 private:
  const TriangleMesh& mesh_;
  double max_distance_;
  const CrackVisit& visit_;
};

}  // namespace

std::vector<std::int32_t> crack_sides(const TriangleMesh& mesh) {
  std::vector<std::int32_t> sides;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.crack_of(h) >= 0) sides.push_back(h);
  }
  return sides;
}

void carry_cracks(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides,
                  double max_distance, const Context& context, const CrackVisit& visit) {
  if (sides.empty()) return;
  // Cracks stay in their part of the mesh, so one part after the other, each in a stretch of memory
  // that the caches hold, comes to the same.
  const Components parts = find_components(mesh);
  std::vector<std::int32_t> order = sides;
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t g, std::int32_t h) {
    return parts.face[g / 3] < parts.face[h / 3];
  });
  Propagation propagation(mesh, max_distance, visit);
  FaceSpread spread(mesh, propagation);
  for (std::size_t i = 0; i < order.size(); ++i) {
    spread.start(order[i] / 3, propagation.source(order[i]));
    const bool last = i + 1 == order.size();
    if (last || parts.face[order[i] / 3] != parts.face[order[i + 1] / 3])
      spread.run("distance", context);
  }
}

NearbyCracks nearby_cracks(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides,
                           double max_distance, const Context& context) {
  NearbyCracks result{max_distance, {}, {}};
  if (sides.empty()) return result;
  AcceptedByFaces<NearbyCrack> seen;
  carry_cracks(mesh, sides, max_distance, context,
               [&](std::int32_t face, const NearbyCrack& crack) { seen.add(face, crack); });
  seen.sort(static_cast<std::size_t>(mesh.face_count()), result.first, result.segments);
  return result;
}

}  // namespace craze
