#include "craze/job/load_surface.h"

#include "craze/shapes.h"

namespace craze {

namespace {

constexpr std::string_view prefix = "shape:";

}  // namespace

bool is_shape(std::string_view input) {
  return input.substr(0, prefix.size()) == prefix;
}

MeshFile load_surface(const std::string& input, const Context& context) {
  context.check();
  context.report({"load"});
  if (is_shape(input)) {
    return {make_shape(input.substr(prefix.size()), context), {}, {}, {}, nullptr};
  }
  return read_mesh_file(input, context);
}

}  // namespace craze
