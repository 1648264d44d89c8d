// The colours that a mesh brings with it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "craze/base/image.h"
#include "craze/material_look.h"
#include "craze/render/material/color.h"

namespace craze::render {

using Rgba = Eigen::Array4f;  ///< linear, alpha last, not premultiplied

/// A colour picture as a function on texture space.
class ColorTexture {
 public:
  /// Of 1 to 4 channels, as sRGB; alpha is 1 where there is none. Not an empty one.
  explicit ColorTexture(const craze::Image& image);

  /// Linear, bilinear between pixel centres; u runs right and v up from the lower left corner, both
  /// repeat. A uv that is not finite counts as (0, 0).
  Rgba sample(const Eigen::Vector2f& uv) const;
  /// Whether no pixel's alpha is below 1.
  bool is_opaque() const { return is_opaque_; }

 private:
  Rgba pixel(std::int32_t x, std::int32_t y) const;

  std::int32_t width_, height_;
  bool is_opaque_ = true;
  std::vector<std::array<std::uint8_t, 4>> pixels_;
  std::array<float, 256> linear_;
};

/// What a look is at a place.
struct LookSample {
  Rgb color;
  float cover = 1;         ///< 0 … 1, part of the place that the surface fills
  float transmission = 0;  ///< of that, part of the light that goes through, in its colour

  /// What is seen of whatever lies behind.
  Rgb clear() const { return 1 - cover + cover * transmission * color; }
};

struct Look {
  using Alpha = MaterialLook::Alpha;

  Rgb color = Rgb::Ones();                      ///< linear; a factor of the texture
  std::shared_ptr<const ColorTexture> texture;  ///< null: none
  /// From (u, v, 1) of the mesh to the texture's (u, v).
  Eigen::Matrix<float, 2, 3> place = Eigen::Matrix<float, 2, 3>::Identity();
  Alpha alpha = Alpha::ignored;
  float opacity = 1;  ///< a factor of the texture's alpha
  float cutoff = 0.5f;
  float transmission = 0;  ///< 0 … 1

  LookSample at(const Eigen::Vector2f& uv) const;
  /// Without the texture.
  LookSample at_factor() const { return of(color, opacity); }
  /// Whether something behind it may be seen somewhere.
  bool is_see_through() const;

 private:
  LookSample of(const Rgb& its_color, float its_alpha) const;
};

}  // namespace craze::render
