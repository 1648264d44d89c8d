#include "craze/model/failure/stress_ahead.h"

#include <gtest/gtest.h>

#include "craze/model/cutting/crack_insertion.h"
#include "craze/model/failure/failure_criterion.h"
#include "model/analytic_surfaces.h"
#include "model/states.h"

namespace craze {
namespace {

constexpr CrackRules ahead_rules{0.2, 1, NearVertex::snap};

/// Opens a crack through v on planes of one normal, of so many segments either way, and returns its
/// tips.
std::vector<std::int32_t> straight_crack(CrackedSheet& sheet, std::int32_t v, const Vec3& normal,
                                         int segments) {
  std::vector<std::int32_t> tips{v};
  std::int32_t label = sheet.mesh().face_count();  // no other crack of the test has it
  for (int i = 0; i < segments; ++i) {
    std::vector<std::int32_t> next;
    for (const std::int32_t tip : tips) {
      CrackOutcome outcome;
      open_crack(sheet, tip, normal, ahead_rules, label, outcome);
      label += static_cast<std::int32_t>(outcome.segments.size());
      next.insert(next.end(), outcome.tips.begin(), outcome.tips.end());
    }
    tips = next;
  }
  return tips;
}

std::int32_t node_next_to(const TriangleMesh& mesh, const Vec3& p) {
  std::int32_t nearest = 0;
  for (std::int32_t v = 1; v < mesh.vertex_count(); ++v) {
    if ((mesh.position(v) - p).norm() < (mesh.position(nearest) - p).norm()) nearest = v;
  }
  return nearest;
}

Vec3 face_normal(const TriangleMesh& mesh, std::int32_t f) {
  const Mat32 frame = tangent_frame(mesh, f);
  return frame.col(0).cross(frame.col(1));
}

/// `stress` on the faces whose centroid fits, none elsewhere.
template <class Predicate>
StressField field_where(const TriangleMesh& mesh, const Sym3& stress, Predicate&& fits) {
  std::vector<Sym3> all(mesh.face_count());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    if (fits(test::centroid(mesh, f))) all[f] = stress;
  }
  return test::field_of(mesh, all);
}

const Sym3 tension{2, 1, 0, 0.3, 0, 0};

TEST(StressAhead, EvenTensionIsFoundAsItIs) {
  CrackedSheet sheet = test::sheet_of(test::plate(20, 1, 0.3), tension);
  const TriangleMesh& mesh = sheet.mesh();
  const StressField& field = sheet.field();
  const std::vector<std::int32_t> tips =
      straight_crack(sheet, node_next_to(mesh, Vec3::Zero()), Vec3::UnitY(), 3);
  ASSERT_EQ(tips.size(), 2U);
  StressAhead ahead;
  for (const std::int32_t tip : tips) {
    ASSERT_TRUE(is_crack_tip(mesh, tip));
    for (const double length : {0.1, 0.3, 5.0}) {
      const Mat3 mean = ahead.mean(mesh, field, tip, length).matrix();
      EXPECT_TRUE(mean.isApprox(tension.matrix(), 1e-12)) << mean;
    }
  }
}

TEST(StressAhead, OnlyWhatIsAheadAndNearCounts) {
  CrackedSheet sheet = test::sheet_of(test::plate(20, 1, 0), Sym3{});
  const TriangleMesh& mesh = sheet.mesh();
  const std::vector<std::int32_t> tips =
      straight_crack(sheet, node_next_to(mesh, Vec3::Zero()), Vec3::UnitY(), 2);
  ASSERT_EQ(tips.size(), 2U);
  StressAhead ahead;
  for (const std::int32_t tip : tips) {
    const Vec3 end = mesh.position(tip);
    const double side = end.x() > 0 ? 1 : -1;
    constexpr double length = 0.2;
    const auto mean = [&](auto&& fits) {
      return ahead.mean(mesh, field_where(mesh, tension, fits), tip, length).matrix().norm();
    };
    const auto is_ahead = [&](const Vec3& p) { return side * (p - end).x() > 0; };
    const auto is_near = [&](const Vec3& p) { return (p - end).norm() < length; };
    EXPECT_NEAR(mean(is_ahead), tension.matrix().norm(), 1e-12);
    EXPECT_NEAR(mean(is_near), tension.matrix().norm(), 1e-12);
    EXPECT_EQ(mean([&](const Vec3& p) { return !is_ahead(p); }), 0);
    EXPECT_EQ(mean([&](const Vec3& p) { return !is_near(p); }), 0);
  }
}

TEST(StressAhead, NearFacesWeighMore) {
  CrackedSheet sheet = test::sheet_of(test::plate(40, 1, 0), Sym3{});
  const TriangleMesh& mesh = sheet.mesh();
  const std::int32_t tip =
      straight_crack(sheet, node_next_to(mesh, Vec3::Zero()), Vec3::UnitY(), 2)[0];
  // Of the integral of (1 − r²)² over a half disk, what lies within r = ½: 1 − (3/4)³.
  const StressField near = field_where(mesh, Sym3{1, 0, 0, 0, 0, 0}, [&](const Vec3& p) {
    return (p - mesh.position(tip)).norm() < 0.15;
  });
  EXPECT_NEAR(StressAhead().mean(mesh, near, tip, 0.3).xx, 1 - 27.0 / 64, 0.02);
}

TEST(StressAhead, NothingBeyondACrackCounts) {
  CrackedSheet sheet = test::sheet_of(test::plate(20, 1, 0), Sym3{});
  const TriangleMesh& mesh = sheet.mesh();
  // A wall from border to border, and a crack that ends two edges before it.
  straight_crack(sheet, node_next_to(mesh, {0.25, 0, 0}), Vec3::UnitX(), 12);
  std::vector<std::int32_t> tips =
      straight_crack(sheet, node_next_to(mesh, Vec3::Zero()), Vec3::UnitY(), 3);
  ASSERT_EQ(tips.size(), 2U);
  const std::int32_t tip = mesh.position(tips[0]).x() > 0 ? tips[0] : tips[1];
  ASSERT_NEAR(mesh.position(tip).x(), 0.15, 1e-12);
  StressAhead ahead;
  constexpr double length = 0.4;
  const StressField beyond = field_where(mesh, tension, [](const Vec3& p) { return p.x() > 0.25; });
  EXPECT_EQ(ahead.mean(mesh, beyond, tip, length).matrix().norm(), 0);
  const StressField before = field_where(mesh, tension, [](const Vec3& p) { return p.x() < 0.25; });
  EXPECT_TRUE(ahead.mean(mesh, before, tip, length).matrix().isApprox(tension.matrix(), 1e-12));
}

TEST(StressAhead, OnABentSurfaceStressIsTurnedIntoTheTipsPlane) {
  const TriangleMesh cylinder = test::cylinder(48, 1, 0);
  std::vector<Sym3> hoop(cylinder.face_count());
  for (std::int32_t f = 0; f < cylinder.face_count(); ++f) {
    const Vec3 out = face_normal(cylinder, f);
    add_outer(hoop[f], 1, Vec3::UnitZ().cross(out));
  }
  CrackedSheet sheet = test::sheet_of(cylinder, hoop);
  const TriangleMesh& mesh = sheet.mesh();
  const StressField& field = sheet.field();
  const std::vector<std::int32_t> tips =
      straight_crack(sheet, node_next_to(mesh, {1, 0, 0.5}), Vec3::UnitY(), 1);
  ASSERT_EQ(tips.size(), 2U);
  for (const std::int32_t tip : tips) {
    const Vec3 around = Vec3::UnitZ().cross(field.normals()[tip]);
    const Mat3 mean = StressAhead().mean(mesh, field, tip, 0.5).matrix();
    EXPECT_TRUE(mean.isApprox(around * around.transpose(), 1e-9)) << mean;
  }
}

TEST(StressAhead, IsZeroWhereNoFaceIsNearEnough) {
  CrackedSheet sheet = test::sheet_of(test::plate(20, 1, 0), tension);
  const TriangleMesh& mesh = sheet.mesh();
  const StressField& field = sheet.field();
  const std::int32_t tip =
      straight_crack(sheet, node_next_to(mesh, Vec3::Zero()), Vec3::UnitY(), 2)[0];
  EXPECT_EQ(StressAhead().mean(mesh, field, tip, 0.01).matrix().norm(), 0);
}

}  // namespace
}  // namespace craze
