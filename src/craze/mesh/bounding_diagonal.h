// How large an object is.
#pragma once

#include <vector>

#include "craze/base/period.h"
#include "craze/tensor.h"

namespace craze {

/// Length of the diagonal of the box around some points, or of a period; 0 without any.
double bounding_diagonal(const std::vector<Vec3>& positions, const Period& period = {});

}  // namespace craze
