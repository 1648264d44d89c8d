#include "craze/products/field_mesh.h"

#include <algorithm>

#include "craze/engine/cracked_surface.h"
#include "craze/mesh/tangent_frame.h"
#include "craze/model/failure/separation_tensor.h"
#include "craze/model/sources/curvature.h"

namespace craze {

namespace {

using Names = std::vector<std::string>;

/// Appends one scalar attribute per name, n values each. values(i, out) writes those of element i.
template <class Values>
void add_attributes(std::vector<Attribute>& attributes, const Names& names, std::int32_t n,
                    Values&& values) {
  const std::size_t first = attributes.size();
  for (const std::string& name : names) {
    attributes.push_back({name, 1, std::vector<double>(static_cast<std::size_t>(n))});
  }
  std::vector<double> out(names.size());
  for (std::int32_t i = 0; i < n; ++i) {
    values(i, out.data());
    for (std::size_t k = 0; k < names.size(); ++k) attributes[first + k].values[i] = out[k];
  }
}

void put(double* out, const Vec3& a) {
  std::copy(a.data(), a.data() + 3, out);
}

}  // namespace

SurfaceMesh field_mesh(const Result& result, const Context& context) {
  const Simulation& simulation = *result.state().simulation;
  const double curvature_radius = result.report().recipe.simulation.stress.curvature_radius;
  const TriangleMesh& mesh = simulation.mesh();
  const StressField& field = simulation.field();
  const double load = simulation.load_on_field();
  SurfaceMesh fields;
  fields.positions = mesh.positions();
  fields.triangles = mesh.triangles();

  add_attributes(fields.face_attributes, {"s_xx", "s_yy", "s_zz", "s_xy", "s_yz", "s_zx"},
                 mesh.face_count(), [&](std::int32_t f, double* out) {
                   const Sym3 s = load * field.stress(mesh, f);
                   const double values[6] = {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx};
                   std::copy(values, values + 6, out);
                 });
  add_attributes(fields.face_attributes, {"s1", "s2", "dx", "dy", "dz"}, mesh.face_count(),
                 [&](std::int32_t f, double* out) {
                   const Mat32 frame = tangent_frame(mesh, f);
                   const Sym2 sigma = to_frame(load * field.stress(mesh, f), frame);
                   const PrincipalCurvature principal = principal_curvature(sigma, frame);
                   out[0] = principal.k1;
                   out[1] = principal.k2;
                   put(out + 2, principal.direction1);
                 });
  auto& vertex = fields.vertex_attributes;
  const std::int32_t n = mesh.vertex_count();
  add_attributes(vertex, {"fx", "fy", "fz"}, n,
                 [&](std::int32_t v, double* out) { put(out, load * field.force(v)); });
  add_attributes(vertex, {"v", "nx", "ny", "nz", "v2", "r"}, n, [&](std::int32_t v, double* out) {
    const Sym3 separation = load * simulation.separation(v);
    const Eigenpair pair = largest_eigenpair(separation);
    out[0] = std::max(pair.value, 0.0);
    put(out + 1, pair.vector);
    out[4] = separation.xx + separation.yy + separation.zz - pair.value;
    out[5] = largest_eigenpair(simulation.residual(v)).value;
  });
  add_attributes(vertex, {"ux", "uy", "uz"}, n,
                 [&](std::int32_t v, double* out) { put(out, simulation.displacement(v)); });
  const std::vector<PrincipalCurvature> curvature =
      vertex_curvature(mesh, curvature_radius, context);
  add_attributes(vertex, {"k1", "k2"}, n, [&](std::int32_t v, double* out) {
    out[0] = curvature[v].k1;
    out[1] = curvature[v].k2;
  });
  return fields;
}

}  // namespace craze
