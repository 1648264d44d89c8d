#include "craze/engine/roughness/crack_room.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "craze/base/segment_distance.h"

namespace craze {

namespace {

// Of the distance: the other line takes as much, and both are drawn in straight pieces.
constexpr double beside_another = 0.4;
constexpr double beside_border = 0.8;  // which stays where it is
constexpr double inside_turn = 0.5;    // of the radius

template <class Obstacles>
double half_of_longest(const Obstacles& obstacles) {
  double longest = 0;
  for (const auto& o : obstacles) longest = std::max(longest, (o.b - o.a).norm());
  return longest / 2;
}

}  // namespace

std::vector<CrackRoom::Obstacle> CrackRoom::obstacles_of(const CrackNetwork& network,
                                                         const std::vector<CrackChain>& chains,
                                                         const TriangleMesh& mesh,
                                                         const std::vector<std::uint8_t>& closed) {
  std::vector<Obstacle> obstacles;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const ChainLine line(chains[c], network);
    for (std::size_t i = 0; i < chains[c].edges.size(); ++i) {
      const Vec3 &a = line.point(i), &b = line.point(i + 1);
      const double arc = line.start(i) + 0.5 * (b - a).norm();
      obstacles.push_back({a, b, line.at(arc).normal, static_cast<std::int32_t>(c), arc});
    }
  }
  const auto is_open = [&](std::int32_t face) {
    return closed.empty() || closed[static_cast<std::size_t>(mesh.source_face(face))] == 0;
  };
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const std::int32_t beyond = mesh.opposite(h);
    const bool at_border = beyond == TriangleMesh::border;
    const bool at_crack = mesh.is_open(h) && !at_border;
    if (at_crack || (!at_border && (!is_open(h / 3) || is_open(beyond / 3)))) continue;
    const Vec3 a = mesh.position(mesh.from(h));
    obstacles.push_back({a, mesh.position_near(mesh.to(h), a), Vec3::Zero(), -1, 0});
  }
  return obstacles;
}

CrackRoom::CrackRoom(const CrackNetwork& network, const std::vector<CrackChain>& chains,
                     const TriangleMesh& mesh, const std::vector<std::uint8_t>& closed,
                     double reach, double near)
    : period_(network.period),
      reach_(reach),
      near_(near),
      obstacles_(obstacles_of(network, chains, mesh, closed)),
      far_(reach / beside_another + half_of_longest(obstacles_)),
      grid_(far_) {
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    const Vec3 middle = 0.5 * (obstacles_[k].a + obstacles_[k].b);
    cells_[grid_.key(period_.wrapped(middle))].push_back(static_cast<std::int32_t>(k));
  }
}

double CrackRoom::room_beside(const Obstacle& o, const MovingPlace& place, const Vec3& seen) const {
  const Vec3 to_a = o.a - seen, to_b = o.b - seen;
  const Vec3 nearest = to_a + nearest_on_segment(seen, o.a, o.b) * (to_b - to_a);
  if (o.chain < 0) return beside_border * nearest.norm();
  if (o.normal.dot(place.normal) < 0) return reach_;  // the other side of a wall
  if (o.chain != place.chain) return beside_another * nearest.norm();
  if (std::abs(o.arc - place.arc) < near_) return reach_;
  // The circles through points of the line that touch it at the place (Gonzalez & Maddocks 1999).
  double radius = std::numeric_limits<double>::infinity();
  for (const Vec3& q : {to_a, nearest, to_b}) {
    const double aside = place.tangent.cross(q).norm();
    if (aside > 0) radius = std::min(radius, q.squaredNorm() / (2 * aside));
  }
  return inside_turn * radius;
}

double CrackRoom::around(const MovingPlace& place) const {
  double room = reach_;
  period_.for_each_image(place.position, far_, [&](const Vec3& p) {
    grid_.for_each_near(p, far_, [&](std::uint64_t key) {
      const auto cell = cells_.find(key);
      if (cell == cells_.end()) return;
      for (const std::int32_t k : cell->second) {
        const Obstacle& o = obstacles_[k];
        const Vec3 seen = period_.nearest(p, 0.5 * (o.a + o.b));
        room = std::min(room, room_beside(o, place, seen));
      }
    });
  });
  return room;
}

}  // namespace craze
