// When places start to be loaded: what the recipe gives, and what is refused.
#include "craze/model/sources/onset.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "craze/mesh/shapes/periodic_square.h"
#include "error_message.h"
#include "model/states.h"

namespace craze {
namespace {

SimulationParameters plain_layer() {
  SimulationParameters p;
  p.layer.screening_length = 0.1;
  return p;
}

Vec3 middle(const TriangleMesh& mesh, std::int32_t f) {
  const Triangle& t = mesh.triangle(f);
  return (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3;
}

std::string refusal(const SimulationParameters& p, const InputFields& fields = {}) {
  const TriangleMesh mesh = test::mesh_of("plate?n=3");
  const std::string message =
      error_of([&] { onset_per_face(mesh, p, fields); }, ErrorKind::request);
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

InputFields painted(std::vector<double> values) {
  InputFields fields;
  fields.vertex_attributes.push_back({"when", 1, std::move(values)});
  return fields;
}

TEST(Onset, IsNotThereWhereNothingAsksForOne) {
  EXPECT_TRUE(onset_per_face(test::mesh_of("plate?n=3"), plain_layer(), {}).empty());
}

TEST(Onset, OfAPlaneFrontGrowsAlongItsDirectionFromTheFirstPlaceItMeets) {
  const TriangleMesh mesh = test::mesh_of("sphere?n=4");
  SimulationParameters p = plain_layer();
  p.evolution.onset_speed = 0.25;
  p.evolution.onset_direction = {0, 0, -3};
  double first = std::numeric_limits<double>::infinity();
  for (std::int32_t f = 0; f < mesh.face_count(); ++f)
    first = std::min(first, -middle(mesh, f).z());
  const std::vector<double> onset = onset_per_face(mesh, p, {});
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_NEAR(onset[f], 4 * (-middle(mesh, f).z() - first), 1e-12);
  }
}

TEST(Onset, OfAFrontFromFarAwayIsThatOfAPlaneFront) {
  const TriangleMesh mesh = test::mesh_of("plate?n=5");
  SimulationParameters far = plain_layer(), plane = plain_layer();
  far.evolution.onset_speed = plane.evolution.onset_speed = 0.25;
  far.evolution.onset_point = {-1e5, 0, 0};
  plane.evolution.onset_direction = {1, 0, 0};
  const std::vector<double> a = onset_per_face(mesh, far, {}), b = onset_per_face(mesh, plane, {});
  for (std::size_t f = 0; f < a.size(); ++f) EXPECT_NEAR(a[f], b[f], 1e-4);
}

TEST(Onset, OfAPointAttributeAndPictureAddUp) {
  const TriangleMesh mesh = test::mesh_of("plate?n=3");
  SimulationParameters p = plain_layer();
  p.evolution.onset_speed = 2;
  const std::vector<double> front = onset_per_face(mesh, p, {});
  InputFields fields = painted(std::vector<double>(mesh.vertex_count(), 0.5));
  fields.corner_uvs.assign(3 * static_cast<std::size_t>(mesh.face_count()), Vec2(0.5, 0.5));
  fields.onset_texture = {1, 1, {0.25F}};
  p.evolution.onset_attribute = "when";
  p.evolution.onset_texture = "picture";
  p.evolution.max_load = 4;
  const std::vector<double> all = onset_per_face(mesh, p, fields);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_NEAR(all[f], front[f] + 0.5 + 0.25 * 4, 1e-12);
  }
}

TEST(Onset, OfASpeedBeyondAllNumbersIsAtOnceAndOfOneThatIsHardlyAnyIsNever) {
  const TriangleMesh mesh = test::mesh_of("plate?n=3");
  SimulationParameters p = plain_layer();
  p.evolution.onset_speed = std::numeric_limits<double>::max();
  for (const double o : onset_per_face(mesh, p, {})) EXPECT_LT(o, 1e-300);
  p.evolution.onset_speed = std::numeric_limits<double>::min();
  int at_once = 0;
  for (const double o : onset_per_face(mesh, p, {})) {
    EXPECT_TRUE(o == 0 || o > 1e290);
    at_once += o == 0;
  }
  EXPECT_GT(at_once, 0);
}

TEST(Onset, RefusesWhatMeansNothingInOneLine) {
  const auto expect_named = [](const std::string& message, const char* key) {
    EXPECT_NE(message.find(key), std::string::npos) << message;
  };
  const std::size_t vertices = 16;
  SimulationParameters p = plain_layer();
  p.evolution.onset_attribute = "when";
  expect_named(refusal(p), "evolution.onset_attribute");
  std::vector<double> values(vertices, 1);
  values[5] = -0.5;
  EXPECT_NE(refusal(p, painted(values)).find("-0.5"), std::string::npos);
  values[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(p, painted(values)).find("not finite"), std::string::npos);
  p = plain_layer();
  p.evolution.onset_texture = "picture";
  expect_named(refusal(p), "evolution.onset_texture");
  p = plain_layer();
  p.evolution.onset_point = {1, 0, 0};
  expect_named(refusal(p), "evolution.onset_speed");
  p = plain_layer();
  p.evolution.onset_direction = {1, 0, 0};
  expect_named(refusal(p), "evolution.onset_speed");
  p.evolution.onset_speed = 1;
  p.engine = Engine::euler;
  expect_named(refusal(p), "quasistatic");
  p.engine = Engine::quasistatic;
  p.layer.screening_length = 0;
  expect_named(refusal(p), "layer.spacing");
}

TEST(Onset, OfAFrontIsRefusedOnATileWhichHasNoFirstPlace) {
  const SurfaceMesh square = periodic_square(1, 6);
  const TriangleMesh tile(square.positions, square.triangles, {1});
  SimulationParameters p = plain_layer();
  p.evolution.onset_speed = 1;
  const std::string message = error_of([&] { onset_per_face(tile, p, {}); }, ErrorKind::request);
  EXPECT_NE(message.find("tile"), std::string::npos) << message;
}

}  // namespace
}  // namespace craze
