#include "craze/model/relaxation/loading.h"

#include "craze/model/relaxation/growth_loading.h"
#include "craze/model/relaxation/load_factor.h"
#include "craze/model/relaxation/onset_loading.h"
#include "craze/model/relaxation/relaxation.h"

namespace craze {

std::unique_ptr<Loading> make_loading(const SimulationParameters& parameters, InitialLoad initial) {
  if (running_engine(parameters) == Engine::euler) {
    return std::make_unique<GrowthLoading>(parameters.evolution, std::move(initial));
  }
  if (is_staggered(initial.onset)) {
    return std::make_unique<OnsetLoading>(parameters.evolution, std::move(initial));
  }
  return std::make_unique<LoadFactor>(parameters.evolution,
                                      initial.onset.empty() ? 0 : initial.onset.front());
}

}  // namespace craze
