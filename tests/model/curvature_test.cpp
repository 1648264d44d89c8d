#include "craze/model/sources/curvature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "craze/base/random.h"
#include "craze/error.h"
#include "craze/mesh/tangent_frame.h"
#include "model/analytic_surfaces.h"

// Relative error of (κ₁, κ₂) at the faces, rms / worst, on irregular meshes (jitter 0.1 on the
// sphere, 0.2 on the torus with radii 1 and 0.4), with a radius of 2 mean edges h:
//   sphere    1,152: .030/.043   4,608: .009/.019   18,432: .005/.016   73,728: .004/.014
//   torus     1,280: .115/.214   5,120: .033/.069   20,480: .009/.022   46,080: .005/.016
// The irregularity leaves a floor of about .004. It goes with a radius that shrinks more slowly
// than h, here 0.8 √h and 0.5 √h:
//   sphere    1,152: .030/.043   4,608: .014/.019   18,432: .007/.008   73,728: .003/.004
//   torus     1,280: .054/.122   5,120: .025/.055   20,480: .012/.026   46,080: .008/.017

namespace craze {
namespace {

using test::cylinder;
using test::sphere;
using test::torus;

struct Exact {
  double k1, k2;
  Vec3 direction1;
};
using Surface = std::function<Exact(const Vec3&)>;

constexpr double tube = 0.4;

Exact on_sphere(const Vec3&) {
  return {1, 1, Vec3::Zero()};
}
Exact on_cylinder(const Vec3& p) {
  return {1, 0, Vec3(-p.y(), p.x(), 0).normalized()};
}
Exact on_torus(const Vec3& p) {
  const Vec3 outward = Vec3(p.x(), p.y(), 0).normalized();
  const double b = std::atan2(p.z(), p.dot(outward) - 1);
  return {1 / tube, std::cos(b) / (1 + tube * std::cos(b)),
          -std::sin(b) * outward + std::cos(b) * Vec3::UnitZ()};
}

struct Errors {
  double rms = 0, worst = 0, angle = 0;  // relative to the larger |κ|; degrees
};

Errors errors(
    const TriangleMesh& mesh, double radius, const Surface& surface,
    const std::function<bool(const Vec3&)>& counts = [](const Vec3&) { return true; }) {
  const auto tensors = face_curvature(mesh, radius, Context{});
  Errors e;
  int n = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle& t = mesh.triangle(f);
    const Vec3 c = (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3;
    if (!counts(c)) continue;
    const auto p = principal_curvature(tensors[f], tangent_frame(mesh, f));
    const Exact x = surface(c);
    const double scale = std::max(std::abs(x.k1), std::abs(x.k2));
    const double error = std::max(std::abs(p.k1 - x.k1), std::abs(p.k2 - x.k2)) / scale;
    e.worst = std::max(e.worst, error);
    e.rms += error * error;
    ++n;
    const double cosine = std::min(1.0, std::abs(p.direction1.dot(x.direction1)));
    if (!x.direction1.isZero()) e.angle = std::max(e.angle, std::acos(cosine) * 57.29577951);
  }
  e.rms = std::sqrt(e.rms / n);
  return e;
}

TEST(Curvature, ConvergesOnTheSphere) {
  const double jitters[] = {0, 0.1};
  for (const double jitter : jitters) {
    const Errors coarse = errors(sphere(12, 1, jitter), 0, on_sphere);
    const Errors fine = errors(sphere(48, 1, jitter), 0, on_sphere);
    EXPECT_LT(coarse.rms, 0.04);
    EXPECT_LT(fine.rms, 0.007);
    EXPECT_LT(fine.worst, 0.025);
  }
}

TEST(Curvature, ConvergesOnTheTorusInValuesAndDirections) {
  const double jitters[] = {0, 0.2};
  for (const double jitter : jitters) {
    const Errors coarse = errors(torus(16, 1, tube, jitter), 0, on_torus);
    const Errors fine = errors(torus(64, 1, tube, jitter), 0, on_torus);
    EXPECT_LT(coarse.rms, 0.14);
    EXPECT_LT(fine.rms, 0.012);
    EXPECT_LT(fine.worst, 0.03);
    EXPECT_LT(fine.angle, jitter > 0 ? 10 : 1.5);
  }
}

TEST(Curvature, IsExactlyOneSidedOnTheCylinderAndIgnoresItsBorders) {
  const auto everywhere = [](const Vec3&) { return true; };
  EXPECT_LT(errors(cylinder(144, 1, 0), 0, on_cylinder, everywhere).worst, 0.02);
  const auto inside = [](const Vec3& p) { return p.z() > 0.25 && p.z() < 0.75; };
  const Errors e = errors(cylinder(144, 1, 0.2), 0, on_cylinder, inside);
  EXPECT_LT(e.rms, 0.01);
  EXPECT_LT(e.angle, 4);
}

TEST(Curvature, ARadiusThatShrinksLikeTheRootOfTheEdgeConvergesInTheWorstFaceToo) {
  double last = 1;
  const int resolutions[] = {12, 24, 48};
  for (const int n : resolutions) {
    const TriangleMesh mesh = sphere(n, 1, 0.1);
    const double h = default_curvature_radius(mesh) / 2;
    const double worst = errors(mesh, 0.8 * std::sqrt(h), on_sphere).worst;
    EXPECT_LT(worst, 0.65 * last);
    last = worst;
  }
  EXPECT_LT(last, 0.012);
}

TEST(Curvature, AWiderRadiusSeesThroughTheNoiseOfAScan) {
  const TriangleMesh clean = sphere(40, 1, 0.1);
  const double h = default_curvature_radius(clean) / 2;
  std::vector<Vec3> positions = clean.positions();
  Random random(3);
  for (Vec3& p : positions) p *= 1 + 0.05 * h * random.normal();
  const TriangleMesh noisy(positions, clean.triangles());
  const double narrow = errors(noisy, h, on_sphere).rms;
  const double wide = errors(noisy, 6 * h, on_sphere).rms;
  EXPECT_GT(narrow, 1.0);
  EXPECT_LT(wide, 0.08);
}

TEST(Curvature, IsNegativeSeenFromInsideAndScalesWithTheInverseLength) {
  const TriangleMesh ball = sphere(20, 5, 0.1);
  std::vector<Triangle> turned = ball.triangles();
  for (Triangle& t : turned) std::swap(t[1], t[2]);
  const auto outside = vertex_curvature(ball, 0, Context{});
  const auto inside = vertex_curvature(TriangleMesh(ball.positions(), turned), 0, Context{});
  for (std::size_t v = 0; v < outside.size(); ++v) {
    EXPECT_NEAR(outside[v].mean(), 0.2, 0.01);
    EXPECT_NEAR(inside[v].mean(), -outside[v].mean(), 1e-12);
    EXPECT_GE(outside[v].k1, outside[v].k2);
    EXPECT_NEAR(outside[v].gaussian(), 0.04, 0.005);
    EXPECT_NEAR(outside[v].direction1.dot(ball.position(static_cast<std::int32_t>(v))), 0, 0.1);
  }
}

TEST(Curvature, APlateHasNoneAndTheFarSideOfAThinWallDoesNotCount) {
  const TriangleMesh flat = test::plate(12, 1, 0.2);
  for (const Sym2& k : face_curvature(flat, 0.3, Context{})) EXPECT_EQ(k.squared_norm(), 0);

  // Two concentric spheres closer together than the radius: neither feels the other.
  const TriangleMesh outer = sphere(16, 1, 0), inner = sphere(16, 0.98, 0);
  std::vector<Vec3> positions = outer.positions();
  std::vector<Triangle> triangles = outer.triangles();
  const auto shift = static_cast<std::int32_t>(positions.size());
  positions.insert(positions.end(), inner.positions().begin(), inner.positions().end());
  for (const Triangle& t : inner.triangles()) {
    triangles.push_back({t[0] + shift, t[2] + shift, t[1] + shift});
  }
  const auto together = face_curvature(TriangleMesh(positions, triangles), 0.25, Context{});
  const auto alone = face_curvature(outer, 0.25, Context{});
  for (std::size_t f = 0; f < alone.size(); ++f) EXPECT_EQ(together[f].xx, alone[f].xx);
}

TEST(Curvature, IsRefusedWhereItWouldTakeHours) {
  const TriangleMesh mesh = torus(300, 1, tube, 0.2);
  EXPECT_THROW(face_curvature(mesh, 10, Context{}), Error);
  EXPECT_THROW(vertex_curvature(mesh, 10, Context{}), Error);
}

TEST(Curvature, SaysHowFarItIsAndCanBeCancelled) {
  const TriangleMesh mesh = torus(48, 1, tube, 0.2);
  Context context;
  context.threads = 1;
  double last = 0;
  int reports = 0;
  context.progress = [&](const Progress& p) {
    EXPECT_GT(p.fraction, last);
    last = p.fraction;
    ++reports;
  };
  face_curvature(mesh, 0.6, context);
  EXPECT_GT(reports, 2);
  context.cancelled = [&] { return true; };
  EXPECT_THROW(face_curvature(mesh, 0.6, context), Cancelled);
}

TEST(Curvature, IsTheSameOnAnyNumberOfThreads) {
  const TriangleMesh mesh = torus(24, 1, tube, 0.2);
  Context one, four;
  one.threads = 1;
  four.threads = 4;
  const auto a = face_curvature(mesh, 0, one), b = face_curvature(mesh, 0, four);
  for (std::size_t f = 0; f < a.size(); ++f) {
    EXPECT_EQ(a[f].xx, b[f].xx);
    EXPECT_EQ(a[f].xy, b[f].xy);
  }
}

TEST(Curvature, FactorsHaveMeanOneAndDoNotKnowTheUnit) {
  const TriangleMesh small = torus(24, 1, tube, 0), large = torus(24, 100, 100 * tube, 0);
  const auto a = vertex_curvature(small, 0, Context{}), b = vertex_curvature(large, 0, Context{});
  const CurvatureScale scales[] = {CurvatureScale::gaussian, CurvatureScale::mean,
                                   CurvatureScale::frobenius, CurvatureScale::sum_of_squares};
  for (const CurvatureScale scale : scales) {
    const auto x = curvature_factors(a, scale), y = curvature_factors(b, scale);
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += x[i];
      EXPECT_NEAR(x[i], y[i], 1e-9);
    }
    EXPECT_NEAR(sum / static_cast<double>(x.size()), 1, 1e-12);
  }
  for (const double f : curvature_factors(a, CurvatureScale::none)) EXPECT_EQ(f, 1);
}

}  // namespace
}  // namespace craze
