// Coordinates for formats that hold only floats.
#pragma once

#include <array>

#include "craze/base/tensor.h"

namespace craze {

/// The nearest floats. Throws Error(request), naming the format, for a coordinate that is not
/// finite in single precision.
std::array<float, 3> to_floats(const Vec3& p, const char* format);

}  // namespace craze
