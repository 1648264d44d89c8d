#include "craze/job/crack_picture.h"

namespace craze {

render::CrackLines picture_lines(const OpenedSurface& shown, const Result& result, double reach,
                                 const Context& context) {
  const TriangleMesh& mesh = shown.base(result);
  render::CrackLines lines = render::crack_lines(mesh, crack_sides(mesh), reach, context);
  if (shown.shut) return lines;
  lines.open = true;
  lines.places = mesh.positions();
  return lines;
}

}  // namespace craze
