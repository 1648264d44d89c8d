#include "craze/products/maps/pictures/sample_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace craze {

namespace {

struct Between {
  std::int32_t low, high;
  double share;  ///< of high
};

/// The pixel that stands for pixel x of a picture that goes on.
std::int32_t wrapped(double x, std::int32_t size, TextureWrap wrap) {
  if (wrap == TextureWrap::clamp) {
    return static_cast<std::int32_t>(std::clamp(x, 0.0, static_cast<double>(size - 1)));
  }
  const double period = wrap == TextureWrap::mirror ? 2.0 * size : size;
  x -= std::floor(x / period) * period;
  const auto pixel = static_cast<std::int32_t>(std::clamp(x, 0.0, period - 1));
  return pixel < size ? pixel : 2 * size - 1 - pixel;
}

/// The pixels on both sides of x, in pixels from the border of the first.
Between pixels_around(double x, std::int32_t size, TextureWrap wrap) {
  // A middle that rounding misses by less than this is one.
  constexpr double rounding = 1e-6;
  double low = std::floor(x - 0.5);
  double share = x - 0.5 - low;
  if (share < rounding) share = 0;
  if (share > 1 - rounding) {
    share = 0;
    ++low;
  }
  return {wrapped(low, size, wrap), wrapped(low + 1, size, wrap), share};
}

/// In pixels, without the periods that single steps would be lost in.
double in_pixels(double x, std::int32_t size, TextureWrap wrap) {
  if (wrap == TextureWrap::clamp) return std::clamp(x, -1.0, 2.0) * size;
  const double period = wrap == TextureWrap::mirror ? 2 : 1;
  return (x - std::floor(x / period) * period) * size;
}

}  // namespace

Color PictureSampler::color(const Vec2& mesh_uv) const {
  const Vec2 uv = place_ * mesh_uv.homogeneous();
  if (image_.empty() || !uv.allFinite()) return {1, 1, 1, 1};
  const Between x =
      pixels_around(in_pixels(uv.x(), image_.width, wraps_[0]), image_.width, wraps_[0]);
  const Between y =
      pixels_around(in_pixels(1 - uv.y(), image_.height, wraps_[1]), image_.height, wraps_[1]);
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
