#include "craze/model/relaxation/load_factor.h"

#include <algorithm>
#include <cmath>

namespace craze {

bool LoadFactor::advance(double needed, bool) {
  if (needed > parameters_.max_load) {
    reached_max_load_ = std::isfinite(needed);
    load_ = reached_max_load_ ? parameters_.max_load : load_;
    return false;
  }
  load_ = std::max(load_, needed);
  return true;
}

}  // namespace craze
