#include "craze/model/relaxation/loading.h"

#include "craze/model/relaxation/growth_loading.h"
#include "craze/model/relaxation/load_factor.h"
#include "craze/model/relaxation/relaxation.h"

namespace craze {

std::unique_ptr<Loading> make_loading(const SimulationParameters& parameters, InitialLoad initial) {
  if (running_engine(parameters) == Engine::euler) {
    return std::make_unique<GrowthLoading>(parameters.evolution, std::move(initial));
  }
  return std::make_unique<LoadFactor>(parameters.evolution);
}

}  // namespace craze
