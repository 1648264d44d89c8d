// What tests of repairs ask of every repaired mesh, and meshes in need of one.
#pragma once

#include <gtest/gtest.h>

#include "craze/mesh/mesh_summary.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/mesh/validate.h"
#include "craze/repair.h"
#include "craze/surface_mesh.h"

namespace craze::test {

/// A mesh after its repair, which left it valid.
struct Repaired {
  SurfaceMesh surface;
  RepairReport report;
  MeshSummary summary;
};

inline Repaired repaired(const SurfaceMesh& s, double tolerance = 1e-9) {
  Repaired r;
  r.surface = repair(s, {tolerance}, r.report);
  const TriangleMesh mesh(r.surface.positions, r.surface.triangles);
  const auto problems = validate(mesh);
  EXPECT_TRUE(problems.empty()) << problems.front();
  r.summary = summarize(mesh);
  EXPECT_EQ(r.summary.vertices, static_cast<std::int32_t>(r.surface.positions.size()));
  return r;
}

/// Every triangle with corners of its own, as an STL file or a glTF with flat normals holds it.
inline SurfaceMesh exploded(const SurfaceMesh& s) {
  SurfaceMesh e = s;
  e.positions.clear();
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      e.positions.push_back(s.positions[s.triangles[f][i]]);
      e.triangles[f][i] = static_cast<std::int32_t>(3 * f + i);
    }
  }
  return e;
}

inline void append(SurfaceMesh& s, const SurfaceMesh& more, const Vec3& offset, double scale = 1) {
  const auto base = static_cast<std::int32_t>(s.positions.size());
  for (const Vec3& p : more.positions) s.positions.emplace_back(scale * p + offset);
  for (const Triangle& t : more.triangles) {
    s.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
}

inline SurfaceMesh bare(const SurfaceMesh& s) {
  SurfaceMesh b;
  b.positions = s.positions;
  b.triangles = s.triangles;
  return b;
}

}  // namespace craze::test
