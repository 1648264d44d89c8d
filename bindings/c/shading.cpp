// How a mesh of the interface is looked at.
#include "craze/mesh/smooth_normals.h"
#include "craze/products/opening/shading_normals.h"
#include "guard.h"
#include "handles.h"

using namespace craze;
using namespace craze::c;

namespace {

std::vector<Vec3> normals_of(const craze_mesh& mesh, double crease) {
  if (!mesh.mesh->corner_normals.empty()) return mesh.mesh->corner_normals;
  if (!mesh.opening) return smooth_normals(*mesh.mesh, crease);
  return shading_normals(mesh.opening->surface(), mesh.opening->result(), crease);
}

}  // namespace

craze_status craze_mesh_shading(const craze_mesh* mesh, double crease, double* normals,
                                craze_error* error) {
  return guard(error, [&] {
    require(mesh, "mesh");
    require(normals, "normals");
    if (!(crease >= 0)) wrong_argument("wrong angle", "crease", "must be 0 or more, degrees");
    for (const Vec3& n : normals_of(*mesh, crease)) {
      *normals++ = n.x();
      *normals++ = n.y();
      *normals++ = n.z();
    }
  });
}
