// The surfaces and stresses that the benchmarks run on.
#pragma once

#include <string>

#include "craze/base/random.h"
#include "craze/mesh/tangent_frame.h"
#include "craze/model/basis_matrix.h"
#include "craze/model/stress_field.h"
#include "craze/shapes.h"

namespace craze::bench {

inline TriangleMesh mesh_of(const std::string& shape) {
  SurfaceMesh s = make_shape(shape);
  return {std::move(s.positions), std::move(s.triangles)};
}

inline TriangleMesh plate(std::int64_t n) {
  return mesh_of("plate?jitter=0.3&n=" + std::to_string(n));
}

/// Tension 1 plus noise of that standard deviation in every component: no node is at rest. With
/// noise 1 many elements are under compression.
inline StressField noisy_field(const TriangleMesh& mesh, double noise) {
  Random random(1);
  StressField field(mesh, singular_value_cap(mesh));
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Sym2 s{1 + noise * random.normal(), 1 + noise * random.normal(), noise * random.normal()};
    field.add_stress(mesh, f, to_world(s, tangent_frame(mesh, f)));
  }
  field.update_forces(mesh);
  return field;
}

}  // namespace craze::bench
