#include "craze/render/film.h"

#include <algorithm>
#include <cmath>

#include "craze/base/progress_meter.h"
#include "craze/base/reporting_loop.h"

namespace craze::render {

Film::Film(int width, int height, const Context& context) : width_(width), height_(height) {
  constexpr std::size_t at_once = std::size_t{1} << 20;
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  pixels_.reserve(size);
  while (pixels_.size() < size) {
    context.check();
    pixels_.resize(std::min(size, pixels_.size() + at_once));
  }
}

void Film::smooth_light(const Context& context, float pixel_size) {
  smoothed_.resize(pixels_.size());
  for (std::size_t i = 0; i < pixels_.size(); ++i) smoothed_[i] = pixels_[i].light;
  // A filter with holes, growing: [Dammertz et al. 2010, "Edge-avoiding à-trous wavelet
  // transform"].
  double part = 0;
  for (const int step : {1, 2, 4}) {
    smooth_once(phase_part(context, "develop", part, part + 0.25), pixel_size, step);
    part += 0.25;
  }
}

void Film::smooth_once(const Context& context, float pixel_size, int step) {
  const std::vector<Rgb> before = smoothed_;
  const float depth_range = 2.5f * pixel_size * static_cast<float>(step);
  reporting_loop(
      context, "develop", static_cast<std::size_t>(height_), 8,
      [&](std::size_t begin, std::size_t end) {
        for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
          for (int x = 0; x < width_; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * width_ + x;
            const Pixel& here = pixels_[i];
            if (here.normal.isZero()) continue;
            const float own = luminance(before[i]);
            // Shadows on the floor are soft and take fewer samples.
            const float light_range =
                (here.floor > 0.99f ? 0.8f : 0.18f) / static_cast<float>(step);
            Rgb sum = 4 * before[i];
            float weights = 4;
            for (int dy = -step; dy <= step; dy += step) {
              for (int dx = -step; dx <= step; dx += step) {
                const int px = x + dx, py = y + dy;
                if ((dx == 0 && dy == 0) || px < 0 || py < 0 || px >= width_ || py >= height_)
                  continue;
                const std::size_t j = static_cast<std::size_t>(py) * width_ + px;
                const Pixel& there = pixels_[j];
                const float facing = here.normal.dot(there.normal);
                if (facing < 0.8f) continue;
                const float off_plane = std::abs((there.position - here.position).dot(here.normal));
                if (off_plane > depth_range) continue;
                const float difference = (luminance(before[j]) - own) / light_range;
                const float w = (dx == 0 || dy == 0 ? 2.0f : 1.0f) * facing * facing /
                                (1 + difference * difference);
                sum += w * before[j];
                weights += w;
              }
            }
            smoothed_[i] = sum / weights;
          }
        }
      });
}

Image Film::develop(float exposure, const Context& context) const {
  Image image{width_, height_, std::vector<std::uint8_t>(3 * pixels_.size())};
  constexpr std::size_t grain = 4096;
  const double smoothing = smoothed_.empty() ? 0 : 0.75;
  reporting_loop(phase_part(context, "develop", smoothing, 1), "develop", pixels_.size(), grain,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const Pixel& p = pixels_[i];
                     Rgb color = p.diffuse + p.direct;
                     if (!smoothed_.empty()) color += p.albedo * (smoothed_[i] - p.light);
                     for (int k = 0; k < 3; ++k) {
                       const float c = linear_to_srgb(tone_curve(exposure * color[k]));
                       image.rgb[3 * i + k] =
                           static_cast<std::uint8_t>(std::lround(255 * std::clamp(c, 0.0f, 1.0f)));
                     }
                   }
                 });
  return image;
}

}  // namespace craze::render
