// Adhesion against the solutions known in closed form: div σ = κ u, the shear-lag film.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "craze/model/screening.h"
#include "model/states.h"

namespace craze {
namespace {

using test::field_of;
using test::mesh_of;

/// σ_max / σ₀ in a strip of length 8 under uniaxial tension along it, at equilibrium.
double strip_maximum(double screening_length, double cell) {
  const TriangleMesh mesh = mesh_of("strip?n=2&length=8&width=" + std::to_string(2 * cell));
  StressField field = field_of(mesh, {1, 0, 0, 0, 0, 0});
  test::relax(mesh, field, {0.2, 1 / (screening_length * screening_length), 0},
              static_cast<std::int64_t>(200 / (cell * cell)));
  double largest = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    largest = std::max(largest, field.stress(mesh, f).xx);
  }
  return largest;
}

TEST(Adhesion, AStripUnderTensionReachesOneMinusSech) {
  for (const double screening_length : {1.0, 2.0, 4.0}) {
    const double expected = 1 - 1 / std::cosh(8 / (2 * screening_length));
    EXPECT_NEAR(strip_maximum(screening_length, 0.1) / expected, 1, 0.01);
  }
}

TEST(Adhesion, TheStripsErrorFallsWithTheMesh) {
  const double expected = 1 - 1 / std::cosh(8 / (2 * 2.0));
  const double coarse = std::abs(strip_maximum(2, 0.4) - expected);
  const double middle = std::abs(strip_maximum(2, 0.2) - expected);
  const double fine = std::abs(strip_maximum(2, 0.1) - expected);
  EXPECT_LT(middle, 0.4 * coarse);
  EXPECT_LT(fine, 0.4 * middle);
}

TEST(Adhesion, TheProfileAlongTheStripIsThatOfShearLag) {
  const TriangleMesh mesh = mesh_of("strip?n=2&length=8&width=0.2");
  StressField field = field_of(mesh, {1, 0, 0, 0, 0, 0});
  test::relax(mesh, field, {0.2, 1.0, 0}, 20000);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle& t = mesh.triangle(f);
    const double x =
        (mesh.position(t[0]).x() + mesh.position(t[1]).x() + mesh.position(t[2]).x()) / 3;
    EXPECT_NEAR(field.stress(mesh, f).xx, 1 - std::cosh(x) / std::cosh(4), 0.05);
  }
}

TEST(Adhesion, ScreeningLengthAndSpacingSetKappa) {
  SimulationParameters p;
  EXPECT_EQ(adhesion(resolve_lengths(p, 1).layer), 0);
  p.layer.relative_spacing = 0.1;
  p.evolution.max_load = 2;
  const double length = resolve_lengths(p, 30).layer.screening_length;
  EXPECT_DOUBLE_EQ(length, 3 / spacing_per_screening_length(p));
  p.layer.spacing = 6;  // what is given in length units goes first
  EXPECT_DOUBLE_EQ(resolve_lengths(p, 30).layer.screening_length, 2 * length);
  p.layer.screening_length = 0.25;
  EXPECT_DOUBLE_EQ(adhesion(resolve_lengths(p, 30).layer), 16);
}

// A plate with a slit along the middle of y = 0, |x| < reach.
struct SlitPlate {
  CrackedSheet sheet;
  const TriangleMesh& mesh = sheet.mesh();
  StressField& field = sheet.field();
};

SlitPlate with_slit(const Sym3& stress, double reach) {
  CrackedSheet sheet = test::sheet_of(mesh_of("plate?n=40"), stress);
  const TriangleMesh& mesh = sheet.mesh();
  for (std::int32_t h = 0, halfedges = 3 * mesh.face_count(); h < halfedges; ++h) {
    const Vec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h));
    const bool on_slit = std::abs(a.y()) + std::abs(b.y()) < 1e-9 && std::abs(a.x()) < reach &&
                         std::abs(b.x()) < reach;
    if (on_slit && !mesh.is_open(h)) sheet.cut(h, 0);
  }
  return {std::move(sheet)};
}

/// Mean stress of the faces within a tenth of the plate of the slit's middle.
Sym3 stress_at_slit(const SlitPlate& plate) {
  Sym3 sum;
  double area = 0;
  for (std::int32_t f = 0; f < plate.mesh.face_count(); ++f) {
    const Triangle& t = plate.mesh.triangle(f);
    const Vec3 centre =
        (plate.mesh.position(t[0]) + plate.mesh.position(t[1]) + plate.mesh.position(t[2])) / 3;
    if (std::abs(centre.y()) > 0.02 || std::abs(centre.x()) > 0.1) continue;
    sum += plate.mesh.area(f) * plate.field.stress(plate.mesh, f);
    area += plate.mesh.area(f);
  }
  return (1 / area) * sum;
}

TEST(Relaxation, RelievesStressPerpendicularToACrackAndKeepsTheParallel) {
  // ℓ = 0.06: the slit, 0.7 long, is far from its tips and from the plate's border in the middle.
  SlitPlate plate = with_slit({1, 1, 0, 0, 0, 0}, 0.36);
  test::relax(plate.mesh, plate.field, {0.2, 1 / (0.06 * 0.06), 0}, 3000);
  const Sym3 at_slit = stress_at_slit(plate);
  EXPECT_LT(at_slit.yy, 0.25);  // at a mean distance of 0.0125: 1 − exp(−0.0125/0.06) = 0.19
  EXPECT_GT(at_slit.xx, 0.95);
}

TEST(Relaxation, ACrackPerpendicularToTheTensionUnloadsItsSurroundingsAlsoWithoutAdhesion) {
  SlitPlate plate = with_slit({0, 1, 0, 0, 0, 0}, 0.36);
  // Held above and below, free at the sides.
  std::vector<char> fixed(plate.mesh.vertex_count());
  for (std::int32_t v = 0; v < plate.mesh.vertex_count(); ++v) {
    fixed[v] = std::abs(plate.mesh.position(v).y()) > 0.4999;
  }
  test::relax(plate.mesh, plate.field, {0.2, 0, 0}, 5000, fixed);
  EXPECT_LT(std::abs(stress_at_slit(plate).yy), 0.1);
}

TEST(Relaxation, ACrackAlongTheTensionChangesNothing) {
  SlitPlate plate = with_slit({1, 0, 0, 0, 0, 0}, 0.36);
  std::vector<char> fixed(plate.mesh.vertex_count());
  for (std::int32_t v = 0; v < plate.mesh.vertex_count(); ++v) {
    fixed[v] = std::abs(plate.mesh.position(v).x()) > 0.4999;
  }
  test::relax(plate.mesh, plate.field, {0.2, 0, 0}, 500, fixed);
  for (std::int32_t f = 0; f < plate.mesh.face_count(); ++f) {
    EXPECT_LT(test::distance(plate.field.stress(plate.mesh, f), {1, 0, 0, 0, 0, 0}), 1e-12);
  }
}

}  // namespace
}  // namespace craze
