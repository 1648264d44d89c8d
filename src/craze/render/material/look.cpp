#include "craze/render/material/look.h"

#include <algorithm>
#include <cmath>

namespace craze::render {

namespace {

/// The two pixels around coordinate s of an axis that repeats, and the weight of the second.
struct Neighbours {
  std::int32_t first, second;
  float weight;
};

Neighbours neighbours(float s, std::int32_t n) {
  if (!std::isfinite(s)) s = 0;
  const float x = (s - std::floor(s)) * static_cast<float>(n) - 0.5f, low = std::floor(x);
  const auto i = static_cast<std::int32_t>(low);
  return {(i + n) % n, (i + 1) % n, x - low};
}

}  // namespace

ColorTexture::ColorTexture(const craze::Image& image, Encoding encoding)
    : width_(image.width), height_(image.height) {
  const auto byte = [&](std::int32_t x, std::int32_t y, int c) {
    const double value = std::clamp(image.value(x, y, c), 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255 * value));
  };
  pixels_.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  const bool grey = image.channels < 3, has_alpha = image.channels % 2 == 0;
  for (std::int32_t y = 0; y < height_; ++y) {
    for (std::int32_t x = 0; x < width_; ++x) {
      const std::uint8_t alpha = has_alpha ? byte(x, y, image.channels - 1) : 255;
      if (alpha < 255) is_opaque_ = false;
      pixels_.push_back({byte(x, y, 0), byte(x, y, grey ? 0 : 1), byte(x, y, grey ? 0 : 2), alpha});
    }
  }
  for (int i = 0; i < 256; ++i) {
    const float value = static_cast<float>(i) / 255.0f;
    linear_[i] = encoding == Encoding::srgb ? srgb_to_linear(value) : value;
  }
}

Rgba ColorTexture::pixel(std::int32_t x, std::int32_t y) const {
  const auto& p = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                          static_cast<std::size_t>(x)];
  return {linear_[p[0]], linear_[p[1]], linear_[p[2]], static_cast<float>(p[3]) / 255};
}

Rgba ColorTexture::sample(const Eigen::Vector2f& uv) const {
  const Neighbours c = neighbours(uv.x(), width_), r = neighbours(1 - uv.y(), height_);
  const auto row = [&](std::int32_t y) -> Rgba {
    return (1 - c.weight) * pixel(c.first, y) + c.weight * pixel(c.second, y);
  };
  return (1 - r.weight) * row(r.first) + r.weight * row(r.second);
}

Rgba ColorTexture::sample(Eigen::Vector2f uv, const TextureWraps& wraps) const {
  const auto inside = [](float s, TextureWrap wrap, std::int32_t n) {
    if (wrap == TextureWrap::repeat || !std::isfinite(s)) return s;
    if (wrap == TextureWrap::mirror) {
      s -= 2 * std::floor(s / 2);
      if (s > 1) s = 2 - s;
    }
    const float half = 0.5f / static_cast<float>(n);  // a pixel: beyond, the last ones go on
    return std::clamp(s, half, 1 - half);
  };
  return sample({inside(uv.x(), wraps[0], width_), inside(uv.y(), wraps[1], height_)});
}

LookSample Look::of(const Rgb& its_color, float its_alpha, float its_transmission) const {
  LookSample sample{its_color, 1, its_transmission};
  if (alpha == Alpha::cut) sample.cover = its_alpha < cutoff ? 0 : 1;
  if (alpha == Alpha::blended) sample.cover = std::clamp(its_alpha, 0.0f, 1.0f);
  return sample;
}

LookSample Look::at(const Eigen::Vector2f& uv, const Eigen::Vector2f& transmission_uv) const {
  const float through = transmission_picture
                            ? transmission * transmission_picture.at(transmission_uv)[0]
                            : transmission;
  if (!picture) return of(color, opacity, through);
  const Rgba sample = picture.at(uv);
  return of(color * sample.head<3>(), opacity * sample[3], through);
}

Vec3f Look::tangent_normal(const Eigen::Vector2f& uv) const {
  if (!normals) return Vec3f::UnitZ();
  Vec3f n = 2 * normals.at(uv).head<3>().matrix() - Vec3f::Ones();
  n.head<2>() *= normal_strength;
  n.normalize();
  return n.allFinite() && n.z() > 0 ? n : Vec3f::UnitZ();
}

bool Look::is_see_through() const {
  if (transmission > 0) return true;
  if (alpha == Alpha::ignored) return false;
  return (picture && !picture.texture->is_opaque()) || at_factor().cover < 1;
}

}  // namespace craze::render
