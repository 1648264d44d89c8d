// post.face_roughness: broken faces that are rough in depth too.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/products/growth/crack_sites.h"
#include "craze/products/opening/opening.h"

namespace craze {

struct FaceOptions {
  double amplitude = 0;   ///< length, > 0: as the roughness of a line
  double usual = 1;       ///< the usual length of a crack, > 0
  double exponent = 0.8;  ///< Hurst's, in (0, 1)
  double step = 0;        ///< between points in depth, at most; 0: usual / 16
  std::uint64_t seed = 0;
};

/// The most triangles that walls become.
inline constexpr double most_wall_triangles = 1048576;
/// The most rows of a wall.
inline constexpr int most_wall_rows = 64;

/// Divides the walls of `opened`, which was made of `mesh`, into rows, and moves their points
/// aside: across the crack's line, by a self-affine field in space, of which the differences to the
/// rim and to the lower edge count, so that both stay as they are. Both faces of a crack are moved
/// alike and so fit. Where lines of cracks end, at junctions, tips and borders, nothing is moved,
/// and less beside them. Where a face would turn over or cross what it did not cross when flat it
/// is moved less. Gives what could not be done as asked, a sentence each. Throws Cancelled.
std::vector<std::string> make_faces_rough(const TriangleMesh& mesh, const CrackSites& sites,
                                          const FaceOptions& options, OpenedMesh& opened,
                                          const Context& context);

}  // namespace craze
