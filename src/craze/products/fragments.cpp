#include "craze/mesh/mesh_parts.h"
#include "craze/products.h"

namespace craze {

std::vector<SurfaceMesh> fragments(const SurfaceMesh& mesh, const Context& context) {
  std::vector<SurfaceMesh> pieces;
  for (const MeshPart& part : mesh_parts(mesh, "fragment")) {
    context.check();
    pieces.push_back(extract_part(mesh, part.faces).mesh);
  }
  return pieces;
}

}  // namespace craze
