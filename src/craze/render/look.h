// The colours that a mesh brings with it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "craze/base/image.h"
#include "craze/render/color.h"

namespace craze::render {

/// A colour picture as a function on texture space.
class ColorTexture {
 public:
  /// Of 1 to 4 channels, as sRGB; alpha counts for nothing. Not an empty one.
  explicit ColorTexture(const craze::Image& image);

  /// Linear, bilinear between pixel centres; u runs right and v up from the lower left corner, both
  /// repeat. A uv that is not finite counts as (0, 0).
  Rgb sample(const Eigen::Vector2f& uv) const;

 private:
  Rgb pixel(std::int32_t x, std::int32_t y) const;

  std::int32_t width_, height_;
  std::vector<std::array<std::uint8_t, 3>> pixels_;
  std::array<float, 256> linear_;
};

struct Look {
  Rgb color = Rgb::Ones();                      ///< linear; a factor of the texture
  std::shared_ptr<const ColorTexture> texture;  ///< null: none
  /// From (u, v, 1) of the mesh to the texture's (u, v).
  Eigen::Matrix<float, 2, 3> place = Eigen::Matrix<float, 2, 3>::Identity();

  Rgb at(const Eigen::Vector2f& uv) const;
};

}  // namespace craze::render
