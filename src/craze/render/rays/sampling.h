// Well-spread sample points, the same for a pixel whatever the order pixels are drawn in.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/render/material/color.h"

namespace craze::render {

struct Point2f {
  float x, y;
};

/// Index `index` of the first two dimensions of Sobol's sequence in [0, 1), shuffled and
/// nested-uniform scrambled by `seed` [Laine & Karras 2011, "Stratified sampling for stochastic
/// transparency", section 3.1].
Point2f sobol_point(std::uint32_t index, std::uint32_t seed);

/// The samples of one pixel, `count` of each kind; those with the same index belong together.
struct PixelSamples {
  const Point2f* lens;  ///< offsets from the pixel's centre in pixels, a tent filter of radius 1
  const Point2f* lamp;  ///< on the unit disc
  const Point2f* sky;   ///< on the unit disc
  const Point2f* aperture;  ///< on the unit disc
};

/// A fixed number of sample sets; each pixel picks from them by its number.
class SampleTable {
 public:
  SampleTable(int count, std::uint64_t seed);

  PixelSamples of_pixel(std::uint64_t pixel) const;

 private:
  static constexpr std::uint32_t sets = 64;

  std::size_t count_;
  std::uint64_t seed_;
  std::vector<Point2f> lens_, disc_, aperture_;  // set by set
};

/// Two unit vectors that complete n (unit) to a right-handed frame.
void complete_frame(const Vec3f& n, Vec3f& s, Vec3f& t);

/// A point on the unit disc, lifted onto the hemisphere about n: density cosine / π.
Vec3f cosine_direction(const Vec3f& n, Point2f on_disc);

/// A direction uniform in a narrow cone about the unit vector `axis`.
Vec3f cone_direction(const Vec3f& axis, float tan_half_angle, Point2f on_disc);

}  // namespace craze::render
