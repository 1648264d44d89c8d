#include "craze/products/opening/shading_normals.h"

#include "craze/engine/cracked_surface.h"
#include "craze/mesh/smooth_normals.h"
#include "craze/products/opening/opened_attributes.h"

namespace craze {

std::vector<Vec3> shading_normals(const OpenedSurface& shown, const Result& result, double crease) {
  if (!shown.mesh.corner_normals.empty()) return shown.mesh.corner_normals;
  if (shown.curled) return smooth_normals(shown.mesh, crease);
  SurfaceMesh smooth;
  smooth.positions = result.state().surface->positions;
  smooth.triangles = result.state().surface->triangles;
  smooth.corner_normals = smooth_normals(smooth, crease);
  std::vector<Vec3> normals = result.state().with_attributes(smooth).corner_normals;
  for (std::size_t f = normals.size() / 3; f < shown.mesh.triangles.size(); ++f) {
    const Triangle& t = shown.mesh.triangles[f];
    const Vec3& p = shown.mesh.positions[t[0]];
    const Vec3 n = (shown.mesh.positions[t[1]] - p).cross(shown.mesh.positions[t[2]] - p);
    for (int i = 0; i < 3; ++i) {
      const std::int32_t above = corner_above(shown.base(result), shown.opened, f, i);
      const bool is_core =
          above >= 0 && static_cast<std::int32_t>(f) >= shown.opened.solid->core_begin;
      normals.push_back(above < 0 ? Vec3(n.stableNormalized())
                                  : Vec3((is_core ? 1 : -1) * normals[above]));
    }
  }
  return normals;
}

}  // namespace craze
