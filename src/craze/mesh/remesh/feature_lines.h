// The edges of a surface that a remesher has to keep as lines.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/mesh/triangle_mesh.h"
#include "craze/surface_mesh.h"

namespace craze {

/// Why an edge is kept; the larger one wins.
enum FeatureLine : char {
  no_feature = 0,
  crease = 1,  ///< a sharp fold, or the border: may be straightened within the allowed distance
  seam = 2,    ///< UVs or materials differ across it: attributes depend on its exact course
};

/// 3 #F, one of FeatureLine per halfedge, the same on both sides of an edge. An edge is a crease
/// where the normals of its faces differ by more than `angle` degrees, and on the border. The
/// spokes of a pole, where each face has a UV of its own for one and the same vertex, are no seams.
std::vector<char> feature_lines(const SurfaceMesh& surface, const TriangleMesh& mesh, double angle);

/// The marks without creases inside the surface that are shorter, together with those they touch,
/// than four times the edge length wanted there (#V): the noise of a scan.
std::vector<char> without_short_creases(const TriangleMesh& mesh, std::vector<char> marks,
                                        const std::vector<double>& wanted);

/// #F: the number of the patch each face lies in; patches are parted by halfedges with marks ≥
/// `least`. opposite(h) gives the other side of h, negative on a border.
template <class Opposite>
std::vector<std::int32_t> patches(std::int32_t faces, const std::vector<char>& marks, char least,
                                  Opposite&& opposite) {
  std::vector<std::int32_t> patch(faces, -1), stack;
  std::int32_t count = 0;
  for (std::int32_t start = 0; start < faces; ++start) {
    if (patch[start] >= 0) continue;
    patch[start] = count;
    stack.push_back(start);
    while (!stack.empty()) {
      const std::int32_t f = stack.back();
      stack.pop_back();
      for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::int32_t o = opposite(h);
        if (o < 0 || marks[h] >= least || patch[o / 3] >= 0) continue;
        patch[o / 3] = count;
        stack.push_back(o / 3);
      }
    }
    ++count;
  }
  return patch;
}

}  // namespace craze
