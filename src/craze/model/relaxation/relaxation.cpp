#include "craze/model/relaxation/relaxation.h"

#include "craze/model/basis_matrix.h"
#include "craze/model/relaxation/equilibrium_relaxation.h"
#include "craze/model/relaxation/flow_relaxation.h"
#include "craze/model/screening.h"

namespace craze {

Engine running_engine(const SimulationParameters& parameters) {
  return adhesion(parameters.layer) > 0 ? parameters.engine : Engine::euler;
}

std::unique_ptr<Relaxation> make_relaxation(const TriangleMesh& mesh, const StressField& field,
                                            const SimulationParameters& parameters) {
  if (running_engine(parameters) == Engine::euler) {
    return std::make_unique<FlowRelaxation>(mesh, field, parameters);
  }
  return std::make_unique<EquilibriumRelaxation>(mesh, parameters);
}

double engine_singular_value_cap(const TriangleMesh& mesh, Engine engine) {
  // The equilibrium solver is stable with any element: there the cap only keeps the stiffest
  // slivers from costing iterations.
  constexpr double implicit_factor = 10;
  return singular_value_cap(mesh) * (engine == Engine::euler ? 1 : implicit_factor);
}

}  // namespace craze
