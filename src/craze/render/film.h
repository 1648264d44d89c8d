// Collects samples and develops them into a picture.
#pragma once

#include <vector>

#include "craze/context.h"
#include "craze/render/image.h"
#include "craze/render/material/color.h"

namespace craze::render {

/// The mean of a pixel's samples. Light is kept apart from the surface's colour, so that the noise
/// of the light can be smoothed without blurring crack lines.
struct Pixel {
  Rgb albedo = Rgb::Zero();      ///< diffuse reflectance
  Rgb light = Rgb::Zero();       ///< irradiance / π
  Rgb diffuse = Rgb::Zero();     ///< mean of albedo × light
  Rgb direct = Rgb::Zero();      ///< seen as it is: reflections, glass, backdrop
  Vec3f normal = Vec3f::Zero();  ///< unit; zero where nothing is lit
  Vec3f position = Vec3f::Zero();
  float floor = 0;  ///< part of the pixel that shows the floor
};

class Film {
 public:
  /// Throws Cancelled: a large film takes seconds to make.
  Film(int width, int height, const Context& context);

  int width() const { return width_; }
  int height() const { return height_; }
  Pixel& at(int x, int y) { return pixels_[static_cast<std::size_t>(y) * width_ + x]; }

  /// Smooths the light over pixels of one surface. `pixel_size` is the width of a pixel at the
  /// object's distance, in render units. This and develop() throw Cancelled.
  void smooth_light(const Context& context, float pixel_size);
  Image develop(float exposure, const Context& context) const;

 private:
  void smooth_once(const Context& context, float pixel_size, int step);

  int width_, height_;
  std::vector<Pixel> pixels_;
  std::vector<Rgb> smoothed_;  // light after smoothing; empty before
};

}  // namespace craze::render
