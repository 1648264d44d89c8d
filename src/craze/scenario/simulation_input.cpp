#include "craze/scenario/simulation_input.h"

namespace craze {

SurfaceMesh simulation_surface(SurfaceMesh repaired, const Recipe&) {
  return repaired;
}

SimulationFields simulation_fields(const SurfaceMesh& surface,
                                   const SimulationParameters& parameters, const Context&) {
  const auto& t = parameters.stress.tensor;
  const double c = parameters.stress.uniform;
  SimulationFields fields;
  fields.stress.assign(surface.triangles.size(), {c + t[0], c + t[1], c + t[2], t[3], t[4], t[5]});
  return fields;
}

}  // namespace craze
