// Which cracks each face can see: the crack edges near it along the surface.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/tensor.h"

namespace craze {

/// A crack edge as seen from a face: unfolded over the edges between them into the plane of that
/// face, so a straight distance to it there is a distance along the surface.
struct NearbyCrack {
  Vec3 a, b;              ///< unfolded positions of from(halfedge) and to(halfedge)
  std::int32_t halfedge;  ///< the side of a crack that it is
};

/// Per face, every crack edge that can be the nearest one to some point of the face.
struct NearbyCracks {
  double max_distance = 0;          ///< cracks farther away than this are not listed
  std::vector<std::int32_t> first;  ///< #F + 1, offsets into segments; empty: no face sees any
  std::vector<NearbyCrack> segments;

  std::span<const NearbyCrack> of(std::int32_t face) const {
    if (first.empty()) return {};
    const auto begin = static_cast<std::size_t>(first[face]);
    return {segments.data() + begin, static_cast<std::size_t>(first[face + 1]) - begin};
  }
};

/// The halfedges that are sides of a crack, ascending.
std::vector<std::int32_t> crack_sides(const TriangleMesh& mesh);

/// Of the corners of a face, from a crack edge.
using CornerDistances = std::array<double, 3>;

/// What to do with a crack edge that a face sees. Several threads do at a time, each with a
/// `worker` of its own, in [0, threads), that all faces of a part of the mesh share.
using CrackVisit = std::function<void(int worker, std::int32_t face, const NearbyCrack& crack,
                                      const CornerDistances& distances)>;

/// Carries each of `sides` (halfedges, seen from their own faces) outwards over the faces, nearest
/// first and never across an open edge, until max_distance or until a nearer crack covers the face.
/// Every crack edge that can be the nearest one to some point of a face is visited for that face,
/// the nearest first. A crack on the far side of a thin wall is as far away as the way round.
/// Infinity is a valid max_distance. Cost: proportional to the faces within reach; kept are 8 bytes
/// for each visit, 20 for each face, 72 for each of the parts at work, and the cracks that are on
/// their way. Parts of the mesh that no face joins go in parallel. Throws Cancelled.
void carry_cracks(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides,
                  double max_distance, const Context& context, const CrackVisit& visit);

/// All of them, by face.
NearbyCracks nearby_cracks(const TriangleMesh& mesh, const std::vector<std::int32_t>& sides,
                           double max_distance, const Context& context);

}  // namespace craze
