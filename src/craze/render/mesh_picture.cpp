#include "craze/render/mesh_picture.h"

#include "craze/products/distance/crack_seams.h"
#include "craze/render/material/crack_lines.h"
#include "craze/repair.h"

namespace craze {

render::Image mesh_picture(const SurfaceMesh& mesh, const render::PictureOptions& options,
                           const Context& context) {
  RepairOptions keep_apart;
  keep_apart.tolerance = -1;
  RepairReport report;
  const SurfaceMesh surface = repair(mesh, keep_apart, report, context);
  const TriangleMesh topology(surface.positions, surface.triangles);
  render::PictureOptions of_subject = options;
  if (options.subject.points.empty()) of_subject.subject = render::subject_of(surface);
  const render::CrackLines lines = render::crack_lines(
      topology, crack_seams(surface, topology), render::line_reach(surface, of_subject), context);
  return render::render_picture(surface, &lines, of_subject, context);
}

}  // namespace craze
