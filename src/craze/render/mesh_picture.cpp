#include "craze/render/mesh_picture.h"

#include <algorithm>

#include "craze/products/distance/seams.h"
#include "craze/render/crack_lines.h"
#include "craze/repair.h"

namespace craze {

namespace {

/// The sides of shut cracks, ascending.
std::vector<std::int32_t> shut_crack_sides(const TriangleMesh& mesh, const Attribute* distance) {
  std::vector<std::int32_t> sides = seam_sides(mesh);
  if (!distance) return sides;
  const auto is_texture_seam = [&](std::int32_t h) {
    return distance->values[mesh.from(h)] > 0 || distance->values[mesh.to(h)] > 0;
  };
  sides.erase(std::remove_if(sides.begin(), sides.end(), is_texture_seam), sides.end());
  return sides;
}

}  // namespace

render::Image mesh_picture(const SurfaceMesh& mesh, const render::PictureOptions& options,
                           const Context& context) {
  RepairOptions keep_apart;
  keep_apart.tolerance = -1;
  RepairReport report;
  const SurfaceMesh surface = repair(mesh, keep_apart, report, context);
  const TriangleMesh topology(surface.positions, surface.triangles);
  const Attribute* distance = find_attribute(surface.vertex_attributes, "crack_distance");
  const render::CrackLines lines =
      render::crack_lines(topology, shut_crack_sides(topology, distance),
                          render::line_reach(surface, options), context);
  return render::render_picture(surface, &lines, options, context);
}

}  // namespace craze
