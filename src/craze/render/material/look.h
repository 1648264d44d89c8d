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

/// How a picture's numbers are meant.
enum class Encoding { srgb, linear };

/// A picture as a function on texture space.
class ColorTexture {
 public:
  /// Of 1 to 4 channels; alpha is linear, and 1 where there is none. Not an empty one.
  explicit ColorTexture(const craze::Image& image, Encoding encoding = Encoding::srgb);

  /// Linear, bilinear between pixel centres; u runs right and v up from the lower left corner, both
  /// repeat. A uv that is not finite counts as (0, 0).
  Rgba sample(const Eigen::Vector2f& uv) const;
  /// The same where the picture goes on in other ways.
  Rgba sample(Eigen::Vector2f uv, const TextureWraps& wraps) const;
  /// Whether no pixel's alpha is below 1.
  bool is_opaque() const { return is_opaque_; }

 private:
  Rgba pixel(std::int32_t x, std::int32_t y) const;

  std::int32_t width_, height_;
  bool is_opaque_ = true;
  std::vector<std::array<std::uint8_t, 4>> pixels_;
  std::array<float, 256> linear_;
};

/// A picture where it lies on a mesh.
struct PlacedTexture {
  std::shared_ptr<const ColorTexture> texture;  ///< null: none
  /// From (u, v, 1) of the mesh to the texture's (u, v).
  Eigen::Matrix<float, 2, 3> place = Eigen::Matrix<float, 2, 3>::Identity();
  TextureWraps wraps{};
  std::size_t uv_set = 0;  ///< of the mesh

  explicit operator bool() const { return texture != nullptr; }
  /// At UVs of the mesh; there must be a texture.
  Rgba at(const Eigen::Vector2f& uv) const {
    return texture->sample(place * Eigen::Vector3f(uv.x(), uv.y(), 1), wraps);
  }
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

  Rgb color = Rgb::Ones();  ///< linear; a factor of the picture
  PlacedTexture picture{};
  Alpha alpha = Alpha::ignored;
  float opacity = 1;  ///< a factor of the picture's alpha
  float cutoff = 0.5f;
  float transmission = 0;                ///< 0 … 1; a factor of its picture's red
  PlacedTexture transmission_picture{};  ///< linear
  PlacedTexture normals{};               ///< linear, tangent space
  float normal_strength = 1;             ///< of their slopes

  LookSample at(const Eigen::Vector2f& uv) const { return at(uv, uv); }
  /// At the UVs of its picture and of its transmission's.
  LookSample at(const Eigen::Vector2f& uv, const Eigen::Vector2f& transmission_uv) const;
  /// Without the pictures.
  LookSample at_factor() const { return of(color, opacity, transmission); }
  /// The normal along tangent (of growing u), bitangent (of growing v) and normal, unit; (0, 0, 1)
  /// where there is no picture.
  Vec3f tangent_normal(const Eigen::Vector2f& uv) const;
  /// Whether something behind it may be seen somewhere.
  bool is_see_through() const;

 private:
  LookSample of(const Rgb& its_color, float its_alpha, float its_transmission) const;
};

}  // namespace craze::render
