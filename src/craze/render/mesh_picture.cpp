#include "craze/render/mesh_picture.h"

#include "craze/mesh/corners_on_surface.h"
#include "craze/mesh/repair/traced_repair.h"
#include "craze/products/distance/crack_seams.h"
#include "craze/render/material/crack_lines.h"

namespace craze {

render::Image mesh_picture(const SurfaceMesh& mesh, const render::PictureOptions& options,
                           const Context& context) {
  RepairOptions keep_apart;
  keep_apart.tolerance = -1;
  RepairReport report;
  const TracedSurface traced = traced_repair(mesh, keep_apart, report, context);
  const SurfaceMesh& surface = traced.surface;
  const TriangleMesh topology(surface.positions, surface.triangles);
  render::PictureOptions of_subject = options;
  for (std::vector<Vec2>& uvs : of_subject.further_uvs) {
    if (!uvs.empty()) uvs = uvs_on_surface(uvs, traced.origin.whole());
  }
  if (options.subject.points.empty()) of_subject.subject = render::subject_of(surface);
  const render::CrackLines lines = render::crack_lines(
      topology, crack_seams(surface, topology), render::line_reach(surface, of_subject), context);
  return render::render_picture(surface, &lines, of_subject, context);
}

}  // namespace craze
