// Small simulations that several tests start from.
#pragma once

#include <string>

#include "craze/model/simulation.h"
#include "model/states.h"

namespace craze::test {

/// By the paper's scheme: mud on a plate or glaze on a sphere, small enough to crack in a fraction
/// of a second.
inline SimulationParameters small_run() {
  SimulationParameters p;
  p.engine = Engine::euler;
  p.material.toughness = 0.03;
  p.layer.screening_length = 0.12;
  p.evolution.relaxation_steps = 5;
  return p;
}

/// A layer of mud by quasi-static flow.
inline SimulationParameters layer_run() {
  SimulationParameters p;
  p.engine = Engine::quasistatic;
  p.material.criterion = Criterion::strength;
  p.material.relative_toughness = 0.3;
  p.layer.screening_length = 0.12;
  p.evolution.max_load = 2;
  p.crack.snap_angle = 10;
  p.crack.back_angle = 60;
  return p;
}

/// Isotropic tension 1 with 5 % noise.
inline SimulationFields noisy_tension(const TriangleMesh& mesh, std::uint64_t seed) {
  SimulationFields fields;
  Random random(seed);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const double c = 1 + 0.05 * random.normal();
    fields.stress.push_back(to_world(Sym2::isotropic(c), tangent_frame(mesh, f)));
  }
  return fields;
}

inline Simulation simulation_of(const std::string& shape, const SimulationParameters& parameters,
                                std::uint64_t seed = 1, int threads = 1) {
  const TriangleMesh mesh = mesh_of(shape);
  Context context;
  context.threads = threads;
  return {mesh, noisy_tension(mesh, seed), parameters, context};
}

}  // namespace craze::test
