#include "craze/products/opening/crack_edges.h"

#include <algorithm>
#include <set>
#include <utility>

#include "craze/engine/cracked_surface.h"

namespace craze {

std::vector<std::int32_t> crack_edges(const Result& result, const OpenedSurface& surface) {
  const TriangleMesh& mesh = surface.base(result);
  std::set<std::pair<std::int32_t, std::int32_t>> seen;  // by what the ends are copies of
  std::vector<std::int32_t> edges;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.crack_of(h) < 0) continue;
    const std::int32_t from = mesh.root(mesh.from(h)), to = mesh.root(mesh.to(h));
    if (seen.insert(std::minmax(from, to)).second) edges.push_back(h);
  }
  return edges;
}

}  // namespace craze
