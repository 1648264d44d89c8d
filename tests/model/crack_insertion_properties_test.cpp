// Thousands of random cracks, and what must hold after each of them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "craze/mesh/validate.h"
#include "craze/model/basis_matrix.h"
#include "craze/model/cutting/crack_insertion.h"
#include "model/states.h"

namespace craze {
namespace {

struct Cracked {
  std::vector<Sym3> stress;  // per input face
  CrackedSheet sheet;
  const TriangleMesh& mesh = sheet.mesh();
  const StressField& field = sheet.field();
  double area = mesh.total_area();
  std::int32_t labels = 0;

  Cracked(const TriangleMesh& start, std::uint64_t seed)
      : stress(test::random_stress(start, seed)),
        sheet(test::sheet_of(start, stress, singular_value_cap(start))) {}
};

/// A node: half of the time one that is open already, so that cracks grow, meet and cross.
std::int32_t random_node(const TriangleMesh& mesh, Random& random) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    const auto v = static_cast<std::int32_t>(random.below(mesh.vertex_count()));
    if (mesh.is_open_vertex(v) || attempt % 2 == 1) return v;
  }
  return 0;
}

/// A plane: any, in the surface's own directions, or exactly through a neighbour.
Vec3 random_normal(const TriangleMesh& mesh, std::int32_t v, Random& random) {
  const std::int32_t h = mesh.first_halfedge(v);
  const Vec3 edge = mesh.position(mesh.to(h)) - mesh.position(v);
  switch (random.below(4)) {
    case 0:
      return test::random_unit(random);
    case 1:
      return edge.cross(test::random_unit(random)).normalized();
    case 2:
      return edge.normalized();
    default: {
      const Mat32 frame = tangent_frame(mesh, h / 3);
      const double angle = random.uniform(0, 6.3);
      return std::cos(angle) * frame.col(0) + std::sin(angle) * frame.col(1);
    }
  }
}

/// The input triangles around a node, in the order of its star.
std::vector<std::int32_t> source_star(const TriangleMesh& mesh, std::int32_t v) {
  std::vector<std::int32_t> star;
  mesh.for_each_outgoing(v, [&](std::int32_t h) { star.push_back(mesh.source_face(h / 3)); });
  return star;
}

void open_and_check(Cracked& c, std::int32_t v, const Vec3& normal, const CrackRules& rules) {
  const std::int32_t old_nodes = c.mesh.vertex_count(), old_faces = c.mesh.face_count();
  std::vector<Vec3> forces;
  std::vector<std::vector<std::int32_t>> stars;
  for (std::int32_t n = 0; n < old_nodes; ++n) {
    forces.push_back(c.field.force(n));
    stars.push_back(source_star(c.mesh, n));
  }
  std::vector<Triangle> triangles = c.mesh.triangles();

  CrackOutcome outcome;
  open_crack(c.sheet, v, normal, rules, c.labels, outcome);

  const std::vector<std::string> faults = validate(c.mesh);
  ASSERT_TRUE(faults.empty()) << faults.front();
  ASSERT_NEAR(c.mesh.total_area() / c.area, 1, 1e-12);
  ASSERT_LE(outcome.segments.size(), 2u);
  ASSERT_LE(outcome.tips.size(), outcome.segments.size());
  for (const std::int32_t tip : outcome.tips) {
    ASSERT_TRUE(c.mesh.is_open_vertex(tip));
    ASSERT_EQ(c.mesh.root(tip), tip);
  }
  // Whatever was cut carries its label on both sides.
  for (std::size_t s = 0; s < outcome.segments.size(); ++s) {
    int sides = 0;
    for (std::int32_t h = 0; h < 3 * c.mesh.face_count(); ++h) {
      sides += c.mesh.crack_of(h) == c.labels + static_cast<std::int32_t>(s);
    }
    ASSERT_EQ(sides, 2);
  }
  c.labels += static_cast<std::int32_t>(outcome.segments.size());

  // Children have their parent's stress; only listed old faces changed their corners.
  const std::set<std::int32_t> changed(outcome.changed_faces.begin(), outcome.changed_faces.end());
  for (std::int32_t f = 0; f < c.mesh.face_count(); ++f) {
    if (f < old_faces && changed.count(f) == 0) {
      ASSERT_EQ(c.mesh.triangle(f), triangles[f]);
      continue;
    }
    if (c.mesh.area(f) < 1e-9 * c.area / old_faces) continue;
    ASSERT_LT(test::distance(c.field.stress(c.mesh, f), c.stress[c.mesh.source_face(f)]), 1e-5);
  }
  // Only listed nodes changed their star and their force, and all forces are in step.
  const std::set<std::int32_t> nodes(outcome.changed_nodes.begin(), outcome.changed_nodes.end());
  for (std::int32_t n = 0; n < c.mesh.vertex_count(); ++n) {
    if (nodes.count(n) == 0) {
      ASSERT_LT(n, old_nodes);
      ASSERT_EQ(c.field.force(n), forces[n]);
      ASSERT_EQ(source_star(c.mesh, n), stars[n]);
    }
  }
  StressField fresh = c.field;
  fresh.update_forces(c.mesh);
  for (std::int32_t n = 0; n < c.mesh.vertex_count(); ++n) {
    ASSERT_LE((c.field.force(n) - fresh.force(n)).norm(), 1e-12 * (1 + fresh.force(n).norm()));
  }
}

void crack_at_random(const std::string& shape, std::uint64_t seed, int cracks,
                     const CrackRules& rules) {
  Cracked c(test::mesh_of(shape), seed);
  Random random(seed);
  for (int i = 0; i < cracks && !::testing::Test::HasFatalFailure(); ++i) {
    const std::int32_t v = random_node(c.mesh, random);
    open_and_check(c, v, random_normal(c.mesh, v, random), rules);
  }
  EXPECT_GT(c.labels, cracks / 20) << shape;
}

constexpr CrackRules papers{0.436, 0.262};  // 25° and 15°
constexpr CrackRules loose{0.05, 0.02};     // slivers allowed

TEST(RandomCracks, KeepAreaValidityAndStressOnClosedSurfaces) {
  for (const std::string shape : {"cube?n=1", "cube?n=3", "sphere?n=3", "torus?n=10"}) {
    crack_at_random(shape, 1, 300, papers);
    crack_at_random(shape, 2, 120, loose);
  }
}

TEST(RandomCracks, KeepAreaValidityAndStressOnOpenAndBorderedSurfaces) {
  for (const std::string shape :
       {"plate?n=1", "plate?n=5&jitter=0.4", "cylinder?n=10&open=1", "disc?n=12"}) {
    crack_at_random(shape, 3, 300, papers);
    crack_at_random(shape, 4, 120, loose);
  }
}

TEST(RandomCracks, KeepAreaValidityAndStressOnThinSurfaces) {
  for (const std::string shape :
       {"strip?n=1&length=9", "strip?n=1&length=40&width=0.1", "bowl?n=16&wall=0.02"}) {
    crack_at_random(shape, 5, 300, papers);
    crack_at_random(shape, 6, 120, loose);
  }
}

RC_GTEST_PROP(RandomCracks, KeepEveryLawWhateverTheSeedAndTheAngles, ()) {
  const auto shape = *rc::gen::element<std::string>("plate?n=3&jitter=0.3", "sphere?n=1",
                                                    "cube?n=1", "strip?n=1&length=5");
  const auto seed = *rc::gen::inRange(0, 1000000);
  const auto snap = *rc::gen::inRange(0, 30), back = *rc::gen::inRange(0, 20);
  crack_at_random(shape, seed, 12, {snap * 0.01745, back * 0.01745});
  RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace
}  // namespace craze
