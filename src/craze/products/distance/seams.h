// Cracks of a mesh that comes from a file, where nothing but open edges tells of them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "craze/mesh/triangle_mesh.h"

namespace craze {

/// A piece of an open edge at which the surface goes on.
struct SeamPiece {
  std::int32_t side;   ///< the border halfedge that it is a piece of
  std::int32_t other;  ///< the one on the other side, which runs the other way
  std::int32_t from;   ///< vertices at its ends, along `side`; one for all at a place
  std::int32_t to;
  bool whole;  ///< both sides run from end to end; else one of them was split and the other not
};

/// Whether two border halfedges with the same ends go together more than others at that place.
using GoTogether = std::function<bool(std::int32_t, std::int32_t)>;

/// The pieces of border halfedges that lie on others that run the other way, within the rounding of
/// single precision, each once, by `side`: where one side was split and the other was not, the
/// parts lie on the whole. Where several lie at a place those that go together are paired first.
std::vector<SeamPiece> seam_pieces(const TriangleMesh& mesh, const GoTogether& go_together = {});

/// The border halfedges, ascending, that have such pieces: edges that are open although the surface
/// goes on. These are the cracks of a cracked mesh that was written and read again.
std::vector<std::int32_t> seam_sides(const TriangleMesh& mesh);

}  // namespace craze
