// "A zero mask means no crack there, ever": whole runs, by both engines, on meshes finer than the
// one that was painted.
#include <gtest/gtest.h>

#include "craze/model/crack_network.h"
#include "engine/claims.h"

namespace craze {
namespace {

constexpr double zero_left_of = -0.1;

/// A coarse plate whose attribute "paint" is 0 on the left.
SurfaceMesh painted_plate() {
  SurfaceMesh plate = make_shape("plate?n=10");
  Attribute paint{"paint", 1, {}};
  for (const Vec3& p : plate.positions) paint.values.push_back(p.x() < zero_left_of ? 0 : 1);
  plate.vertex_attributes.push_back(paint);
  return plate;
}

/// A picture, "mask", that is black on the left and grey elsewhere.
Textures mask() {
  GreyImage image{10, 1, {}};
  for (int x = 0; x < image.width; ++x) {
    image.pixels.push_back((x + 0.5F) / 10 - 0.5F < zero_left_of ? 0 : 0.8F);
  }
  return {{"mask", image}};
}

Recipe recipe_of(Engine engine, Criterion criterion) {
  Recipe recipe = read_preset("mud");
  recipe.mesh.edge = {EdgeLength::Kind::given, 0.03};
  SimulationParameters& p = recipe.simulation;
  p.engine = engine;
  p.layer.relative_spacing = 0.15;
  p.evolution.shrinkage = 0.003;
  p.evolution.relaxation_steps = 10;
  p.material.criterion = criterion;
  if (criterion == Criterion::force) p.material.toughness = 0.03;
  if (criterion == Criterion::force) p.material.relative_toughness = 0;
  return recipe;
}

void expect_cracks_only_right_of(const test::Cracked& cracked, double border) {
  const CrackNetwork network = crack_network(cracked.simulation);
  ASSERT_GT(network.edges.size(), 8u);
  for (const CrackNode& node : network.nodes) EXPECT_GE(node.position.x(), border);
}

TEST(AZeroMask, OfAnAttributeKeepsCracksOffTheWholeTrianglesItTouches) {
  for (const Engine engine : {Engine::quasistatic, Engine::euler}) {
    for (const Criterion criterion : {Criterion::strength, Criterion::force}) {
      Recipe strong = recipe_of(engine, criterion);
      strong.simulation.material.attribute = "paint";
      expect_cracks_only_right_of(test::crack(painted_plate(), strong, 1), zero_left_of);
    }
    Recipe spaced = recipe_of(engine, Criterion::strength);
    spaced.simulation.layer.attribute = "paint";
    expect_cracks_only_right_of(test::crack(painted_plate(), spaced, 2), zero_left_of);
  }
}

TEST(AZeroMask, OfAPictureKeepsCracksOffEveryTriangleThatSeesBlack) {
  for (const Engine engine : {Engine::quasistatic, Engine::euler}) {
    Recipe stress = recipe_of(engine, Criterion::strength), material = stress, layer = stress;
    stress.simulation.stress.texture = "mask";
    material.simulation.material.texture = "mask";
    layer.simulation.layer.texture = "mask";
    for (const Recipe& recipe : {stress, material, layer}) {
      expect_cracks_only_right_of(test::crack(painted_plate(), recipe, 3, mask()), zero_left_of);
    }
  }
}

TEST(AZeroMask, LeavesNoTraceInTheOutput) {
  Recipe recipe = recipe_of(Engine::quasistatic, Criterion::strength);
  recipe.simulation.material.attribute = "paint";
  recipe.simulation = resolve_lengths(recipe.simulation, 1);
  const SimulationSurface surface = simulation_surface(painted_plate(), recipe, {});
  ASSERT_EQ(surface.forbidden.size(), surface.mesh.triangles.size());
  EXPECT_TRUE(surface.mesh.face_attributes.empty());
  EXPECT_NE(find_attribute(surface.mesh.vertex_attributes, "paint"), nullptr);
}

}  // namespace
}  // namespace craze
