#include "craze/scenario/shown_surface.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "craze/mesh/transfer_attributes.h"
#include "craze/render/smooth_normals.h"
#include "craze/scenario/opened_surface.h"

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

ShownSurface shown_surface(SurfaceMesh cut, const Simulation& simulation,
                           const PostParameters& post) {
  if (post.gap == 0 && post.wall == 0) {
    OpenedMesh opened = unopened(cut);
    return {std::move(cut), std::move(opened), true, {}};
  }
  const TriangleMesh& mesh = simulation.mesh();
  std::vector<Vec3> displacement(static_cast<std::size_t>(mesh.vertex_count()));
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    displacement[v] = simulation.displacement(v);
  }
  OpeningOptions options;
  options.gap = post.gap;
  options.wall = post.wall;
  options.curl = post.curl;
  ShownSurface shown;
  shown.opened = open_cracks(mesh, displacement, options);
  shown.mesh = opened_surface(cut, mesh, shown.opened, post.curl == 0);
  shown.shut = post.gap == 0;
  shown.warnings = opening_warnings(shown.opened, mesh);
  return shown;
}

std::vector<Vec3> picture_normals(const ShownSurface& shown, const SurfaceMesh& surface,
                                  const Simulation& simulation, const PostParameters& post,
                                  double crease) {
  if (!shown.mesh.corner_normals.empty()) return shown.mesh.corner_normals;
  if (post.curl != 0) return {};
  SurfaceMesh smooth;
  smooth.positions = surface.positions;
  smooth.triangles = surface.triangles;
  for (const render::Vec3f& n : render::smooth_normals(smooth, crease)) {
    smooth.corner_normals.push_back(n.cast<double>());
  }
  std::vector<Vec3> normals = transfer_attributes(smooth, simulation.mesh()).corner_normals;
  for (std::size_t f = normals.size() / 3; f < shown.mesh.triangles.size(); ++f) {
    const Triangle& t = shown.mesh.triangles[f];
    const Vec3& p = shown.mesh.positions[t[0]];
    const Vec3 n = (shown.mesh.positions[t[1]] - p).cross(shown.mesh.positions[t[2]] - p);
    normals.insert(normals.end(), 3, n.stableNormalized());
  }
  return normals;
}

render::CrackLines picture_lines(const ShownSurface& shown, const TriangleMesh& mesh,
                                 double reach) {
  render::CrackLines lines = render::crack_lines(mesh, crack_sides(mesh), reach);
  if (shown.shut) return lines;
  lines.open = true;
  lines.places = mesh.positions();
  return lines;
}

}  // namespace craze
