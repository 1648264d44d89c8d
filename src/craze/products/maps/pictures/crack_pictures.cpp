#include "craze/products/maps/pictures/crack_pictures.h"

#include <algorithm>
#include <cmath>

#include "craze/base/parallel.h"
#include "craze/base/srgb.h"
#include "craze/products/maps/pictures/sample_picture.h"
#include "craze/products/maps/rows_at_once.h"

namespace craze {

namespace {

constexpr double flattest = 1e-3;  // z of a normal that slopes are told from

std::uint8_t eighth(double x) {
  return static_cast<std::uint8_t>(std::floor(std::clamp(x, 0.0, 1.0) * 255 + 0.5));
}

Image empty_picture(int size, int channels) {
  const auto pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  return {size, size, channels,
          std::vector<std::uint8_t>(pixels * static_cast<std::size_t>(channels))};
}

std::uint8_t* pixels_of(Image& image, int y) {
  auto& values = std::get<std::vector<std::uint8_t>>(image.values);
  return values.data() +
         static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width * image.channels);
}

/// Minus the slopes of the surface that has that normal.
Vec2 tilt(double x, double y, double z) {
  return Vec2(x, y) / std::max(z, flattest);
}

}  // namespace

const std::vector<MapKind>& CrackPictures::maps() {
  static const std::vector<MapKind> kinds{MapKind::mask, MapKind::normal, MapKind::occlusion,
                                          MapKind::time};
  return kinds;
}

void CrackPictures::begin(const std::vector<MapHeader>& headers) {
  size_ = headers[0].size;
  tone_ = {stain_.late, headers[3].low[0], headers[3].high[0]};
  const int channels = own_.base_color.image.channels;
  cracked_.base_color.image = empty_picture(size_, channels == 2 || channels == 4 ? 4 : 3);
  cracked_.normal.image = empty_picture(size_, 3);
  cracked_.roughness.image = empty_picture(size_, 3);
}

void CrackPictures::rows(int first, int count, const std::vector<const float*>& maps) {
  parallel_for(context_.threads, static_cast<std::size_t>(count), rows_at_once,
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t r = begin; r < end; ++r) {
                   const std::size_t at = r * static_cast<std::size_t>(size_);
                   compose(first + static_cast<int>(r), maps[0] + at, maps[1] + 3 * at,
                           maps[2] + at, maps[3] + at);
                 }
               });
}

void CrackPictures::compose(int y, const float* mask, const float* normal, const float* light,
                            const float* time) {
  const PictureSampler base(own_.base_color), bumps(own_.normal), shade(own_.occlusion),
      rough(own_.roughness);
  const int channels = cracked_.base_color.image.channels;
  std::uint8_t* base_out = pixels_of(cracked_.base_color.image, y);
  std::uint8_t* normal_out = pixels_of(cracked_.normal.image, y);
  std::uint8_t* rough_out = pixels_of(cracked_.roughness.image, y);
  const double v = 1 - (y + 0.5) / size_;
  for (int x = 0; x < size_; ++x) {
    const Vec2 uv((x + 0.5) / size_, v);
    const double share = mask[x];

    const Color color = base.color(uv);
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<std::size_t>(c);
      if (share <= 0) {
        base_out[channels * x + c] = eighth(color[k]);
        continue;
      }
      const double own = srgb_to_linear(color[k]);
      const double factor = base_factor_[k];
      const double stained = !stain_.color ? CrackStain::darkened * own
                             : factor > 0  ? (*stain_.color)[k] / factor
                                           : 0;
      const double mixed = own + tone_.factor(time[x]) * share * (std::min(stained, 1.0) - own);
      base_out[channels * x + c] = eighth(linear_to_srgb(static_cast<float>(mixed)));
    }
    if (channels == 4) base_out[4 * x + 3] = eighth(color[3]);

    Vec2 sum = tilt(2 * normal[3 * x] - 1, 2 * normal[3 * x + 1] - 1, 2 * normal[3 * x + 2] - 1);
    if (!own_.normal.image.empty()) {
      const Color n = bumps.color(uv);
      sum += own_.normal_scale * tilt(2 * n[0] - 1, 2 * n[1] - 1, 2 * n[2] - 1);
    }
    const Vec3 combined = Vec3(sum.x(), sum.y(), 1).stableNormalized();
    for (int c = 0; c < 3; ++c) normal_out[3 * x + c] = eighth(0.5 + 0.5 * combined[c]);

    double open = 1, roughness = own_.roughness_factor, metal = own_.metallic_factor;
    if (!own_.occlusion.image.empty()) open += own_.occlusion_strength * (shade.color(uv)[0] - 1);
    if (!own_.roughness.image.empty()) {
      const Color surface = rough.color(uv);
      roughness *= surface[1];
      metal *= surface[2];
    }
    rough_out[3 * x] = eighth(open * light[x]);
    rough_out[3 * x + 1] = eighth(roughness + share * (1 - roughness));
    rough_out[3 * x + 2] = eighth(metal * (1 - share));
  }
}

}  // namespace craze
