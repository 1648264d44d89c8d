#include "craze/products/opening/opened_surface.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "craze/engine/cracked_surface.h"
#include "craze/products/opening/opened_attributes.h"

namespace craze {

namespace {

OpenedMesh unopened(const SurfaceMesh& cut) {
  OpenedMesh opened;
  opened.mesh.positions = cut.positions;
  opened.mesh.triangles = cut.triangles;
  opened.vertex_of.resize(cut.positions.size());
  opened.face_of.resize(cut.triangles.size());
  std::iota(opened.vertex_of.begin(), opened.vertex_of.end(), 0);
  std::iota(opened.face_of.begin(), opened.face_of.end(), 0);
  return opened;
}

std::vector<std::string> opening_warnings(const OpenedMesh& opened, const TriangleMesh& mesh) {
  std::vector<std::string> warnings;
  if (opened.limited_vertices > 0) {
    warnings.push_back(fmt::format(
        "post.gap, post.wall and post.curl are more than the surface has room for: at {} of {} "
        "vertices it opens less, down to {:.2g} of what was asked, so that it does not pass "
        "through itself",
        opened.limited_vertices, mesh.vertex_count(), opened.least_share));
  }
  if (opened.crossings > 0 || opened.folded_faces > 0) {
    warnings.push_back(
        fmt::format("the opened surface still passes through itself: {} pairs of triangles cross, "
                    "{} are turned "
                    "over; try a smaller post.gap, post.wall or post.curl",
                    opened.crossings, opened.folded_faces));
  }
  return warnings;
}

}  // namespace

OpenedSurface opened_surface(const Result& result, SurfaceMesh cut, const PostParameters& post,
                             const Context& context) {
  if (post.gap == 0 && post.wall == 0) {
    OpenedMesh opened = unopened(cut);
    return {std::move(cut), std::move(opened), true, {}};
  }
  const Simulation& simulation = *result.state().simulation;
  const TriangleMesh& mesh = simulation.mesh();
  std::vector<Vec3> displacement(static_cast<std::size_t>(mesh.vertex_count()));
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    displacement[v] = simulation.displacement(v);
  }
  OpeningOptions options;
  options.gap = post.gap;
  options.wall = post.wall;
  options.curl = post.curl;
  OpenedSurface surface;
  surface.opened = open_cracks(mesh, displacement, options, context);
  context.check();
  context.report({"open", 1});
  surface.mesh = opened_attributes(cut, mesh, surface.opened, post.curl == 0);
  surface.shut = post.gap == 0;
  surface.warnings = opening_warnings(surface.opened, mesh);
  return surface;
}

}  // namespace craze
