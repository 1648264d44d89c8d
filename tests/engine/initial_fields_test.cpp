#include "craze/engine/initial_fields.h"

#include <gtest/gtest.h>

#include "craze/shapes.h"

namespace craze {
namespace {

SimulationFields fields_of(const SimulationParameters& parameters) {
  const SimulationSurface surface{make_shape("torus?n=30")};
  const TriangleMesh mesh(surface.mesh.positions, surface.mesh.triangles);
  return initial_fields(surface, mesh, parameters, {}, {});
}

TEST(InitialFields, GrowthOfCurvatureIsAStepOfEulersAndASourceOfTheLoadFactors) {
  SimulationParameters p;
  p.stress.noise = 0;
  p.layer.screening_length = 0.2;
  const SimulationFields plain = fields_of(p);
  p.evolution.curvature_growth = 0.3;
  const SimulationFields loaded = fields_of(p);
  p.engine = Engine::euler;
  const SimulationFields stepped = fields_of(p);
  ASSERT_EQ(stepped.growth.size(), plain.stress.size());
  EXPECT_TRUE(loaded.growth.empty());
  double largest = 0;
  for (std::size_t f = 0; f < plain.stress.size(); ++f) {
    const Mat3 growth = stepped.growth[f].matrix();
    EXPECT_EQ(stepped.stress[f].matrix(), plain.stress[f].matrix());
    EXPECT_TRUE((loaded.stress[f].matrix() - plain.stress[f].matrix()).isApprox(growth, 1e-9));
    largest = std::max(largest, growth.norm());
  }
  EXPECT_GT(largest, 0.3);
}

}  // namespace
}  // namespace craze
