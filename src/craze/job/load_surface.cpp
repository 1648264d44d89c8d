#include "craze/job/load_surface.h"

#include "craze/read_mesh.h"
#include "craze/shapes.h"

namespace craze {

namespace {

constexpr std::string_view prefix = "shape:";

}  // namespace

bool is_shape(std::string_view input) {
  return input.substr(0, prefix.size()) == prefix;
}

SurfaceMesh load_surface(const std::string& input) {
  if (is_shape(input)) return make_shape(input.substr(prefix.size()));
  return read_mesh_file(input).mesh;
}

}  // namespace craze
