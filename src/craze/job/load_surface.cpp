#include "craze/job/load_surface.h"

#include "craze/output/source_file.h"
#include "craze/shapes.h"

namespace craze {

MeshFile load_surface(const std::string& input, const Context& context) {
  context.check();
  context.report({"load"});
  if (is_shape(input)) {
    return {make_shape(input.substr(input.find(':') + 1), context), {}, {}, {}, nullptr};
  }
  return read_mesh_file(input, context);
}

}  // namespace craze
