#include "craze/model/relaxation/load_factor.h"

#include <cmath>

namespace craze {

LoadFactor::LoadFactor(const EvolutionParameters& parameters, double start)
    : start_(start),
      max_load_(parameters.max_load),
      load_step_(parameters.load_step),
      highest_(std::max(0.0, std::min(max_load_ - start, parameters.most_load()))) {}

bool LoadFactor::advance(double needed, bool) {
  if (needed > highest_) {
    const bool could_fail = std::isfinite(needed);
    reached_max_load_ = could_fail && start_ + highest_ >= max_load_;
    load_ = could_fail ? highest_ : load_;
    return false;
  }
  load_ = std::max(load_, needed);
  return true;
}

}  // namespace craze
