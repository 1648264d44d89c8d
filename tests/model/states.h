// Meshes and stress states that several tests start from.
#pragma once

#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "craze/base/random.h"
#include "craze/mesh/tangent_frame.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/cracked_sheet.h"
#include "craze/model/relaxation/euler_relaxation.h"
#include "craze/model/stress_field.h"
#include "craze/shapes.h"

namespace craze::test {

constexpr double no_cap = std::numeric_limits<double>::infinity();

inline TriangleMesh mesh_of(const std::string& shape) {
  SurfaceMesh s = make_shape(shape);
  return {std::move(s.positions), std::move(s.triangles)};
}

inline Vec3 centroid(const TriangleMesh& mesh, std::int32_t f) {
  const Triangle& t = mesh.triangle(f);
  return (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3;
}

inline Vec3 random_unit(Random& random) {
  Vec3 v;
  do {
    v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  } while (v.norm() < 0.1 || v.norm() > 1);
  return v.normalized();
}

/// One tensor per face, in the plane of the face, of either sign.
inline std::vector<Sym3> random_stress(const TriangleMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  std::vector<Sym3> stress(mesh.face_count());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Sym2 s{random.normal(), random.normal(), random.normal()};
    stress[f] = to_world(s, tangent_frame(mesh, f));
  }
  return stress;
}

inline StressField field_of(const TriangleMesh& mesh, const std::vector<Sym3>& stress,
                            double cap = no_cap) {
  StressField field(mesh, cap);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) field.add_stress(mesh, f, stress[f]);
  field.update_forces(mesh);
  return field;
}

inline StressField field_of(const TriangleMesh& mesh, const Sym3& stress, double cap = no_cap) {
  return field_of(mesh, std::vector<Sym3>(mesh.face_count(), stress), cap);
}

/// The mesh, under such a stress, ready to be cut.
template <class Stress>
CrackedSheet sheet_of(TriangleMesh mesh, const Stress& stress, double cap = no_cap) {
  StressField field = field_of(mesh, stress, cap);
  return {std::move(mesh), std::move(field)};
}

/// Lets displacements u (#V) strain every face. Returns, per node, by how much its forces changed.
inline std::vector<double> displace_all(const TriangleMesh& mesh, StressField& field,
                                        const std::vector<Vec4d>& u) {
  std::vector<std::int32_t> faces(mesh.face_count()), slot(mesh.vertex_count());
  std::iota(faces.begin(), faces.end(), 0);
  std::iota(slot.begin(), slot.end(), 0);
  std::vector<double> drift(mesh.vertex_count());
  field.displace(mesh, faces, slot, u, drift);
  return drift;
}

/// ½ Σ A |σ|² + ½ κ Σ A_n |u|².
inline double energy(const TriangleMesh& mesh, const StressField& field, double adhesion) {
  double sum = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    sum += 0.5 * mesh.area(f) * field.stress(mesh, f).matrix().squaredNorm();
  }
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    sum += 0.5 * adhesion * field.node_areas()[v] * field.displacement(v).squaredNorm();
  }
  return sum;
}

inline void relax(const TriangleMesh& mesh, StressField& field,
                  const EulerRelaxationOptions& options, std::int64_t steps,
                  const std::vector<char>& fixed = {}, int threads = 1) {
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v]) field.hold(static_cast<std::int32_t>(v));
  }
  EulerRelaxation relaxation(mesh, field, options);
  relaxation.run(field, mesh, steps, threads);
}

/// In double precision throughout: runs of one step each.
inline void relax_one_by_one(const TriangleMesh& mesh, StressField& field,
                             const EulerRelaxationOptions& options, std::int64_t steps) {
  EulerRelaxation relaxation(mesh, field, options);
  for (std::int64_t i = 0; i < steps; ++i) relaxation.run(field, mesh, 1, 1);
}

inline bool same_bytes(const StressField& a, const StressField& b) {
  return std::memcmp(a.elements().data(), b.elements().data(),
                     a.elements().size() * sizeof(Element)) == 0 &&
         std::memcmp(a.displacements().data(), b.displacements().data(),
                     a.displacements().size() * sizeof(Vec4d)) == 0;
}

inline double distance(const Sym3& a, const Sym3& b) {
  return (a.matrix() - b.matrix()).norm();
}

}  // namespace craze::test
