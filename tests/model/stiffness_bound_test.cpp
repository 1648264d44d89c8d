// The bound on the eigenvalues of K that makes the accelerated relaxation stable.
#include "craze/model/relaxation/stiffness_bound.h"

#include <gtest/gtest.h>

#include "craze/model/basis_matrix.h"
#include "craze/model/cutting/crack_insertion.h"
#include "model/states.h"

namespace craze {
namespace {

/// The largest eigenvalue of K, from below, by power iteration.
double largest_eigenvalue(const TriangleMesh& mesh, const StressField& stressed) {
  StressField field(mesh, stressed.singular_value_cap());
  Random random(1);
  std::vector<Vec4d> x(mesh.vertex_count());
  for (Vec4d& v : x) v.v = Vec4d::Lanes{random.normal(), random.normal(), random.normal(), 0};
  double value = 0;
  for (int i = 0; i < 100; ++i) {
    std::fill(field.forces().begin(), field.forces().end(), Vec4d{});
    test::displace_all(mesh, field, x);
    double squares = 0, before = 0;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      squares += field.force(v).squaredNorm();
      before += x[v][0] * x[v][0] + x[v][1] * x[v][1] + x[v][2] * x[v][2];
    }
    value = std::sqrt(squares / before);
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      x[v].v = field.forces()[v].v / std::sqrt(squares);
    }
  }
  return value;
}

TEST(StiffnessBound, LiesAboveTheLargestEigenvalueAndNotFar) {
  for (const std::string shape :
       {"plate?n=12", "plate?n=12&jitter=0.3", "sphere?n=6", "torus?n=16", "cup?n=24"}) {
    const TriangleMesh mesh = test::mesh_of(shape);
    const StressField field(mesh, singular_value_cap(mesh));
    StiffnessBound bound;
    bound.update(mesh, field);
    const double largest = largest_eigenvalue(mesh, field);
    EXPECT_GE(bound.value(), largest) << shape;
    EXPECT_LE(bound.value(), 2.5 * largest) << shape;
  }
}

TEST(StiffnessBound, KeepsUpWithWhateverTheCutsMakeOfTheMesh) {
  // Uncapped, the slivers that cuts leave are as stiff as they are thin.
  CrackedSheet sheet = test::sheet_of(test::mesh_of("plate?n=14&jitter=0.3"), Sym3{}, test::no_cap);
  const TriangleMesh& mesh = sheet.mesh();
  const StressField& field = sheet.field();
  StiffnessBound bound;
  bound.update(mesh, field);
  const double uncut = bound.value();
  Random random(3);
  CrackOutcome outcome;
  for (int i = 0; i < 300; ++i) {
    const auto v = static_cast<std::int32_t>(random.below(mesh.vertex_count()));
    open_crack(sheet, v, test::random_unit(random), {0.05, 0.05}, i, outcome);
    bound.update(mesh, field, outcome.changed_nodes);
  }
  StiffnessBound fresh;
  fresh.update(mesh, field);
  EXPECT_GE(bound.value(), fresh.value());
  EXPECT_GT(bound.value(), uncut);
  EXPECT_GE(bound.value(), largest_eigenvalue(mesh, field));
}

}  // namespace
}  // namespace craze
