#include "craze/products/maps/sample_picture.h"

#include <Eigen/Geometry>
#include <cmath>

namespace craze {

namespace {

struct Between {
  std::int32_t low, high;
  double share;  ///< of high
};

/// The pixels on both sides of x, in pixels from the border of the first.
Between pixels_around(double x, std::int32_t size) {
  // A middle that rounding misses by less than this is one.
  constexpr double rounding = 1e-6;
  double low = std::floor(x - 0.5);
  double share = x - 0.5 - low;
  if (share < rounding) share = 0;
  if (share > 1 - rounding) {
    share = 0;
    ++low;
  }
  low -= std::floor(low / size) * size;
  const auto first = static_cast<std::int32_t>(low) % size;
  return {first, (first + 1) % size, share};
}

}  // namespace

Color PictureSampler::color(const Vec2& mesh_uv) const {
  const Vec2 uv = place_ * mesh_uv.homogeneous();
  if (image_.empty() || !uv.allFinite()) return {1, 1, 1, 1};
  const Between x = pixels_around((uv.x() - std::floor(uv.x())) * image_.width, image_.width);
  const double v = 1 - uv.y();
  const Between y = pixels_around((v - std::floor(v)) * image_.height, image_.height);
  const auto value = [&](int c) {
    const auto along = [&](std::int32_t row) {
      const double low = image_.value(x.low, row, c);
      return x.share > 0 ? low + x.share * (image_.value(x.high, row, c) - low) : low;
    };
    const double low = along(y.low);
    return static_cast<float>(y.share > 0 ? low + y.share * (along(y.high) - low) : low);
  };
  const bool is_grey = image_.channels < 3;
  Color color{value(0), 0, 0, 1};
  color[1] = is_grey ? color[0] : value(1);
  color[2] = is_grey ? color[0] : value(2);
  if (image_.channels % 2 == 0) color[3] = value(image_.channels - 1);
  return color;
}

}  // namespace craze
