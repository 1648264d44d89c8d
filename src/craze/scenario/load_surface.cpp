#include "craze/scenario/load_surface.h"

#include "craze/io/read_mesh.h"
#include "craze/mesh/shapes.h"

namespace craze {

SurfaceMesh load_surface(const std::string& input) {
  constexpr std::string_view prefix = "shape:";
  if (input.compare(0, prefix.size(), prefix) == 0) return make_shape(input.substr(prefix.size()));
  return read_mesh(input);
}

}  // namespace craze
