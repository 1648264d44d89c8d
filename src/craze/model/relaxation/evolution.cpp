#include "craze/model/relaxation/evolution.h"

#include "craze/model/basis_matrix.h"
#include "craze/model/relaxation/euler_evolution.h"
#include "craze/model/relaxation/quasistatic_evolution.h"
#include "craze/model/screening.h"

namespace craze {

Engine running_engine(const SimulationParameters& parameters) {
  return adhesion(parameters.layer) > 0 ? parameters.engine : Engine::euler;
}

std::unique_ptr<Evolution> make_evolution(const TriangleMesh& mesh, const StressField& field,
                                          const SimulationParameters& parameters,
                                          const EvolutionInputs& inputs) {
  if (running_engine(parameters) == Engine::euler) {
    return std::make_unique<EulerEvolution>(mesh, field, parameters, inputs);
  }
  return std::make_unique<QuasistaticEvolution>(mesh, parameters, inputs);
}

double engine_singular_value_cap(const TriangleMesh& mesh, Engine engine) {
  // The equilibrium solver is stable with any element: there the cap only keeps the stiffest
  // slivers from costing iterations.
  constexpr double implicit_factor = 10;
  return singular_value_cap(mesh) * (engine == Engine::euler ? 1 : implicit_factor);
}

}  // namespace craze
