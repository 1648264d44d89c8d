#include "craze/model/sources/stress_sources.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "craze/error.h"
#include "craze/mesh/tangent_frame.h"
#include "craze/model/sources/painted_multiplier.h"
#include "model/analytic_surfaces.h"
#include "model/states.h"

namespace craze {
namespace {

StressParameters nothing() {
  StressParameters p;
  p.uniform = 0;
  p.noise = 0;
  return p;
}

std::vector<Sym2> stress(const TriangleMesh& mesh, const StressParameters& p,
                         const std::vector<Impact>& impacts = {}, const InputFields& fields = {},
                         std::uint64_t seed = 1, int threads = 0) {
  Context context;
  context.threads = threads;
  return initial_stress(mesh, p, impacts, seed, fields, context);
}

/// The plate's own UVs: (0, 0) at the lower left corner.
InputFields with_uvs(const TriangleMesh& mesh) {
  InputFields fields;
  for (const Triangle& t : mesh.triangles()) {
    for (const std::int32_t v : t) {
      const Vec3& p = mesh.position(v);
      fields.corner_uvs.emplace_back(p.x() + 0.5, p.y() + 0.5);
    }
  }
  return fields;
}

template <class Call>
void expect_request(Call&& call, const std::string& text) {
  try {
    call();
    FAIL() << text;
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::request);
    EXPECT_NE(std::string(e.what()).find(text), std::string::npos) << e.what();
  }
}

TEST(StressSources, UniformTensionIsIsotropicInEveryFrame) {
  StressParameters p = nothing();
  p.uniform = 1.5;
  for (const Sym2& s : stress(test::sphere(6, 1, 0.1), p)) {
    EXPECT_DOUBLE_EQ(s.xx, 1.5);
    EXPECT_DOUBLE_EQ(s.yy, 1.5);
    EXPECT_DOUBLE_EQ(s.xy, 0);
  }
}

TEST(StressSources, ATensorGivesTheSameWorldStressWhateverTheFrame) {
  StressParameters p = nothing();
  p.tensor = {3, 1, 7, 0.5, 9, 9};
  const TriangleMesh mesh = test::plate(6, 1, 0.2);
  const auto sigma = stress(mesh, p);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Sym3 world = to_world(sigma[f], tangent_frame(mesh, f));
    EXPECT_NEAR(world.xx, 3, 1e-12);
    EXPECT_NEAR(world.yy, 1, 1e-12);
    EXPECT_NEAR(world.xy, 0.5, 1e-12);
    EXPECT_NEAR(world.zz, 0, 1e-12);
  }
}

TEST(StressSources, CurvatureStressPullsAcrossTheBend) {
  StressParameters p = nothing();
  p.curvature = 2;
  const TriangleMesh mesh = test::cylinder(96, 4, 0);
  const auto sigma = stress(mesh, p);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Vec3 c = test::centroid(mesh, f);
    const Vec3 around = Vec3(-c.y(), c.x(), 0).normalized();
    const Sym3 world = to_world(sigma[f], tangent_frame(mesh, f));
    EXPECT_NEAR(around.dot(world * around), 0.5, 0.01);
    EXPECT_NEAR(world.zz, 0, 1e-3);
  }
}

TEST(StressSources, NoiseHasTheRelativeDeviationAskedForAndFollowsTheSeed) {
  StressParameters p = nothing();
  p.uniform = 4;
  p.noise = 0.05;
  const TriangleMesh mesh = test::plate(60, 1, 0);
  const double lengths[] = {0, 0.02};
  for (const double length : lengths) {
    p.noise_length = length;
    double sum = 0, square = 0;
    const auto sigma = stress(mesh, p);
    for (const Sym2& s : sigma) {
      EXPECT_EQ(s.xx, s.yy);
      sum += s.xx;
      square += s.xx * s.xx;
    }
    const auto n = static_cast<double>(sigma.size());
    const double mean = sum / n;
    EXPECT_NEAR(mean, 4, 0.04);
    EXPECT_NEAR(std::sqrt(square / n - mean * mean) / mean, 0.05, 0.004);
    EXPECT_EQ(sigma[5].xx, stress(mesh, p)[5].xx);
    EXPECT_NE(sigma[5].xx, stress(mesh, p, {}, {}, 2)[5].xx);
  }
  p.noise = 10;
  for (const Sym2& s : stress(mesh, p)) EXPECT_GE(s.xx, 0);
}

TEST(StressSources, AnImpactPullsAlongAndAcrossItsRays) {
  Impact impact;
  impact.point = {0.1, 0.05, 0};
  impact.radius = 0.15;
  impact.radial = 0.5;
  impact.hoop = 3;
  impact.falloff = 2;
  impact.hoop_falloff = 1;
  const TriangleMesh mesh = test::plate(40, 1, 0.2);
  const auto sigma = stress(mesh, nothing(), {impact});
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Vec3 ray = test::centroid(mesh, f) - impact.point;
    const double r = ray.norm(), q = std::max(1.0, r / impact.radius);
    const Vec3 along = ray.normalized(), across = Vec3::UnitZ().cross(along);
    const Sym3 world = to_world(sigma[f], tangent_frame(mesh, f));
    EXPECT_NEAR(world.xx + world.yy, 0.5 / (q * q) + 3 / q, 1e-2);
    if (r < 0.04) continue;  // the face that is hit has no direction
    EXPECT_NEAR(along.dot(world * along), 0.5 / (q * q), 1e-2);
    EXPECT_NEAR(across.dot(world * across), 3 / q, 1e-2);
    EXPECT_NEAR(along.dot(world * across), 0, 1e-2);
  }
}

TEST(StressSources, ImpactsAddUpAndOneFarAwayIsRefused) {
  Impact a, b;
  a.radius = b.radius = 0.1;
  b.point = {0.3, 0.2, 0};
  const TriangleMesh mesh = test::plate(10, 1, 0.2);
  const auto sa = stress(mesh, nothing(), {a}), sb = stress(mesh, nothing(), {b});
  const auto both = stress(mesh, nothing(), {a, b});
  for (std::size_t f = 0; f < both.size(); ++f) {
    EXPECT_NEAR(both[f].xy, sa[f].xy + sb[f].xy, 1e-15);
  }
  b.point = {0, 0, 1};
  expect_request(
      [&] {
        stress(mesh, nothing(), {a, b});
      },
      "point is not on the surface (impact 2): (0 0 1) is 1 away");
}

TEST(StressSources, PaintedScalarsAndTensorsAreAdded) {
  const TriangleMesh mesh = test::plate(8, 1, 0.2);
  InputFields fields;
  Attribute paint{"paint", 1, {}}, field{"field", 6, {}};
  for (const Vec3& p : mesh.positions()) paint.values.push_back(2 + p.x());
  const double tensor_values[] = {5, 0, 0, 1, 0, 0};
  for (std::int32_t i = 0; i < 6 * mesh.face_count(); ++i) {
    field.values.push_back(tensor_values[i % 6]);
  }
  fields.vertex_attributes = {paint};
  fields.face_attributes = {field};
  StressParameters p = nothing();
  p.uniform = 1;
  p.attribute = "paint";
  const auto scalar = stress(mesh, p, {}, fields);
  p.attribute = "field";
  const auto tensor = stress(mesh, p, {}, fields);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_NEAR(scalar[f].xx, 3 + test::centroid(mesh, f).x(), 1e-12);
    EXPECT_NEAR(scalar[f].xy, 0, 1e-12);
    const Sym3 world = to_world(tensor[f], tangent_frame(mesh, f));
    EXPECT_NEAR(world.xx, 6, 1e-12);
    EXPECT_NEAR(world.yy, 1, 1e-12);
    EXPECT_NEAR(world.xy, 1, 1e-12);
  }
}

TEST(StressSources, SixColumnsOfAFieldsFileMakeOneTensor) {
  const TriangleMesh mesh = test::plate(3, 1, 0);
  InputFields fields;
  const char* names[] = {"s_xx", "s_yy", "s_zz", "s_xy", "s_yz", "s_zx"};
  for (int k = 0; k < 6; ++k) {
    fields.face_attributes.push_back(
        {names[k], 1, std::vector<double>(mesh.face_count(), k + 1.0)});
  }
  StressParameters p = nothing();
  p.attribute = "s";
  const auto sigma = stress(mesh, p, {}, fields);
  const Sym3 world = to_world(sigma[4], tangent_frame(mesh, 4));
  EXPECT_NEAR(world.xx, 1, 1e-12);
  EXPECT_NEAR(world.yy, 2, 1e-12);
  EXPECT_NEAR(world.xy, 4, 1e-12);
}

TEST(StressSources, ATextureMultipliesEverythingAndItsBlackForbidsCracks) {
  const TriangleMesh mesh = test::plate(32, 1, 0.2);
  InputFields fields = with_uvs(mesh);
  fields.stress_texture = {4, 1, {0, 0, 1, 1}};  // black on the left half
  SimulationParameters parameters;
  parameters.stress = nothing();
  parameters.stress.uniform = 2;
  parameters.stress.texture = "mask.png";
  const auto sigma = stress(mesh, parameters.stress, {}, fields);
  const auto forbidden = forbidden_faces(mesh, parameters, fields);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const double x = test::centroid(mesh, f).x();
    if (x > -0.33 && x < -0.17) {
      EXPECT_EQ(sigma[f].xx, 0);
      EXPECT_EQ(forbidden[f], 1);
    }
    if (x > 0.17 && x < 0.33) {
      EXPECT_DOUBLE_EQ(sigma[f].xx, 2);
      EXPECT_EQ(forbidden[f], 0);
    }
  }
}

TEST(StressSources, APaintedSourceAloneForbidsWhereItIsZeroButNotBesideAnother) {
  const TriangleMesh mesh = test::plate(6, 1, 0);
  InputFields fields;
  Attribute paint{"paint", 1, {}};
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    paint.values.push_back(test::centroid(mesh, f).x() > 0 ? 1 : 0);
  }
  fields.face_attributes = {paint};
  SimulationParameters p;
  p.stress = nothing();
  p.stress.attribute = "paint";
  const auto alone = forbidden_faces(mesh, p, fields);
  p.stress.uniform = 1;
  const auto beside = forbidden_faces(mesh, p, fields);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_EQ(alone[f] == 1, paint.values[f] == 0);
    EXPECT_EQ(beside[f], 0);
  }
}

TEST(StressSources, PaintedStrengthAndSpacingAreFactorsAndZeroForbids) {
  const TriangleMesh mesh = test::plate(10, 1, 0);
  InputFields fields = with_uvs(mesh);
  Attribute tough{"tough", 1, {}};
  for (const Vec3& p : mesh.positions()) tough.values.push_back(p.y() > 0.25 ? 0 : 1 - p.x());
  fields.vertex_attributes = {tough};
  fields.material_texture = {1, 1, {0.5f}};
  SimulationParameters p;
  p.material.attribute = "tough";
  p.material.texture = "half.png";
  const PaintedMultiplier m = material_multiplier(mesh, p.material, fields);
  const auto forbidden = forbidden_faces(mesh, p, fields);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_DOUBLE_EQ(m.vertex[v], 0.5 * tough.values[v]);
  }
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_EQ(forbidden[f] == 1, test::centroid(mesh, f).y() > 0.2)
        << test::centroid(mesh, f).transpose();
  }
  for (const double x : spacing_multiplier(mesh, p.layer, fields).face) EXPECT_EQ(x, 1);
  fields.vertex_attributes[0].values[3] = -1;
  expect_request([&] { material_multiplier(mesh, p.material, fields); }, "must not be negative");
}

TEST(StressSources, VertexColoursCanBeThePaint) {
  SurfaceMesh surface;
  surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  surface.triangles = {{0, 1, 2}};
  surface.vertex_colors = {{1, 0, 0, 1}, {1, 1, 1, 1}, {0, 0, 0, 0.25f}};
  const TriangleMesh mesh(surface.positions, surface.triangles);
  const InputFields fields = input_fields(surface);
  EXPECT_NEAR(scalar_per_vertex(mesh, fields, "color", "k")[0], 0.2126, 1e-6);
  EXPECT_NEAR(scalar_per_vertex(mesh, fields, "color", "k")[1], 1, 1e-6);
  EXPECT_EQ(scalar_per_vertex(mesh, fields, "color_a", "k")[2], 0.25);
}

TEST(StressSources, AWrongNameSaysWhichThereAre) {
  const TriangleMesh mesh = test::plate(2, 1, 0);
  InputFields fields;
  fields.vertex_attributes = {{"wetness", 1, std::vector<double>(mesh.vertex_count(), 1.0)},
                              {"flow", 3, std::vector<double>(3 * mesh.vertex_count(), 1.0)}};
  StressParameters p = nothing();
  p.attribute = "wettness";
  expect_request([&] { stress(mesh, p, {}, fields); },
                 "cannot use painted values (stress.attribute): the input has no attribute "
                 "\"wettness\"; per vertex it has wetness, flow, per face none");
  p.attribute = "flow";
  expect_request([&] { stress(mesh, p, {}, fields); }, "has 3 components");
  fields.vertex_attributes[0].values[3] = std::nan("");
  p.attribute = "wetness";
  expect_request([&] { stress(mesh, p, {}, fields); }, "not finite at vertex 3");
  p.attribute = "";
  p.texture = "mask.png";
  fields.stress_texture = {1, 1, {1.0f}};
  expect_request([&] { stress(mesh, p, {}, fields); }, "no texture coordinates");
}

TEST(StressSources, IsTheSameOnAnyNumberOfThreads) {
  StressParameters p = nothing();
  p.noise = 0.1;
  p.noise_length = 0.3;
  p.uniform = 1;
  p.curvature = 0.2;
  const TriangleMesh mesh = test::torus(24, 1, 0.4, 0.2);
  Impact impact;
  impact.point = {1.4, 0, 0};
  const auto one = stress(mesh, p, {impact}, {}, 1, 1), four = stress(mesh, p, {impact}, {}, 1, 4);
  for (std::size_t f = 0; f < one.size(); ++f) {
    EXPECT_EQ(one[f].xx, four[f].xx);
    EXPECT_EQ(one[f].xy, four[f].xy);
  }
}

TEST(StressSources, RefuseImpactsThatWouldTakeHours) {
  const TriangleMesh mesh = test::plate(30, 1, 0);
  const std::vector<Impact> many(1'000'000);
  EXPECT_THROW(stress(mesh, nothing(), many), Error);
}

TEST(StressSources, AreHeardBetweenImpacts) {
  const TriangleMesh mesh = test::plate(10, 1, 0);
  Context context;
  int reports = 0;
  context.progress = [&](const Progress&) { ++reports; };
  context.cancelled = [&] { return reports == 3; };
  const std::vector<Impact> many(100);
  EXPECT_THROW(initial_stress(mesh, nothing(), many, 1, {}, context), Cancelled);
  EXPECT_EQ(reports, 3);
}

}  // namespace
}  // namespace craze
