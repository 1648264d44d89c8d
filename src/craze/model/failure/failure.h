// How a node would fail, and by what plane it opens.
#pragma once

#include <cstdint>

#include "craze/tensor.h"

namespace craze {

/// How a node would fail.
struct Failure {
  double measure = 0;    ///< v⁺ at load 1 over the threshold; 0: cannot fail
  double threshold = 0;  ///< force
  double weight = 1;     ///< factor on ς there, curvature's
  Vec3 normal = Vec3::Zero();
  std::int32_t shield = -1;  ///< the tip whose process zone alone keeps it from failing
  bool exact = false;        ///< else measure is an upper bound
};

/// By what plane a node opens.
struct CrackPlane {
  Vec3 normal = Vec3::Zero();  ///< unit
  bool ahead_only = false;     ///< it is a tip's, found by what lies ahead: nothing opens behind
};

}  // namespace craze
