#include "craze/job/crack_picture.h"

#include "craze/engine/cracked_surface.h"
#include "craze/render/smooth_normals.h"

namespace craze {

std::vector<Vec3> picture_normals(const OpenedSurface& shown, const Result& result,
                                  const PostParameters& post, double crease) {
  if (!shown.mesh.corner_normals.empty()) return shown.mesh.corner_normals;
  if (post.curl != 0) return {};
  SurfaceMesh smooth;
  smooth.positions = result.state().surface.positions;
  smooth.triangles = result.state().surface.triangles;
  for (const render::Vec3f& n : render::smooth_normals(smooth, crease)) {
    smooth.corner_normals.push_back(n.cast<double>());
  }
  std::vector<Vec3> normals = result.state().with_attributes(smooth).corner_normals;
  for (std::size_t f = normals.size() / 3; f < shown.mesh.triangles.size(); ++f) {
    const Triangle& t = shown.mesh.triangles[f];
    const Vec3& p = shown.mesh.positions[t[0]];
    const Vec3 n = (shown.mesh.positions[t[1]] - p).cross(shown.mesh.positions[t[2]] - p);
    normals.insert(normals.end(), 3, n.stableNormalized());
  }
  return normals;
}

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
