#include "craze/io/polygons/single_precision.h"

#include <limits>
#include <string>

#include "craze/base/error.h"

namespace craze {

std::array<float, 3> to_floats(const Vec3& p, const char* format) {
  // Compared in double: converting a larger number to float is undefined.
  if (!(p.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max())) {
    throw Error(ErrorKind::request, "cannot write mesh", format,
                "a coordinate is too large for this format's single precision");
  }
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

}  // namespace craze
