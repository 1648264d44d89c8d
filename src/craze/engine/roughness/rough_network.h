// post.roughness: cracks whose lines are rough, finer than the mesh that they grew on.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/crack_network.h"

namespace craze {

struct RoughnessOptions {
  double amplitude = 0;   ///< length, > 0
  double exponent = 0.8;  ///< in (0, 1)
  double step = 0;        ///< between points, at most; 0: automatic
  std::uint64_t seed = 0;
  /// Per source face of the mesh: 1 where no crack may run, so that none gets there by its
  /// roughness; empty: nowhere.
  std::vector<std::uint8_t> closed = {};
};

/// What a rough edge was a piece of.
struct SmoothPiece {
  std::int32_t edge;             ///< of the network as it grew
  std::array<double, 2> shares;  ///< of that edge, from a to b: where the piece's ends come from
};

struct RoughNetwork {
  /// Nodes lie beside the surface by what it curves on the way, and know no vertex; a bend's face
  /// is that of the edge it was on.
  CrackNetwork network;
  std::vector<SmoothPiece> pieces;  ///< per edge
  double step = 0;                  ///< between points, at most: what was asked for, or more
  double held_back = 0;  ///< share of the length where other cracks halved the roughness or worse
};

/// The most points that roughness puts on the cracks of a run, besides those that they have.
inline constexpr double most_points = 262144;

/// Moves the cracks aside in the surface, each between its ends by a self-affine profile of its
/// own (self_affine_profile.h). Junctions, tips and ends at the border stay. With ℓ the usual
/// length (crack_chains.h), two points of a crack at the distance r along it are moved by
/// amplitude (r/ℓ)^exponent apart, rms, up to r of about a quarter of its length, where there is
/// room for it (crack_room.h); an amplitude over ℓ counts as ℓ. A step at which they would be
/// moved as far apart as it is long, or that makes more than most_points, is made longer: lines
/// that are steeper than that meet themselves. Every edge keeps what it is known by. The profile of
/// a crack hangs on the seed and on its own event alone, not on the other options nor on threads.
/// Throws Cancelled.
RoughNetwork roughen(const CrackNetwork& network, const TriangleMesh& mesh,
                     const RoughnessOptions& options, const Context& context);

}  // namespace craze
