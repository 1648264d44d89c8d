#include "craze/grey_image.h"

#include <cmath>

namespace craze {

namespace {

/// The two pixels around coordinate s of an axis that repeats, and the weight of the second.
struct Neighbours {
  std::int32_t first, second;
  double weight;
};

Neighbours neighbours(double s, std::int32_t n) {
  if (!std::isfinite(s)) s = 0;
  const double x = (s - std::floor(s)) * n - 0.5, low = std::floor(x);
  const auto i = static_cast<std::int32_t>(low);
  return {(i + n) % n, (i + 1) % n, x - low};
}

}  // namespace

double GreyImage::sample(const Vec2& uv) const {
  const Neighbours c = neighbours(uv.x(), width), r = neighbours(1 - uv.y(), height);
  const auto row = [&](std::int32_t y) {
    const float* p = pixels.data() + static_cast<std::size_t>(y) * width;
    return (1 - c.weight) * p[c.first] + c.weight * p[c.second];
  };
  return (1 - r.weight) * row(r.first) + r.weight * row(r.second);
}

bool GreyImage::touches_black(const Vec2& uv) const {
  const Neighbours c = neighbours(uv.x(), width), r = neighbours(1 - uv.y(), height);
  const auto black = [&](std::int32_t y, std::int32_t x, double weight) {
    return weight > 0 && pixels[static_cast<std::size_t>(y) * width + x] == 0;
  };
  return black(r.first, c.first, (1 - r.weight) * (1 - c.weight)) ||
         black(r.first, c.second, (1 - r.weight) * c.weight) ||
         black(r.second, c.first, r.weight * (1 - c.weight)) ||
         black(r.second, c.second, r.weight * c.weight);
}

}  // namespace craze
