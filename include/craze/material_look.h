// How a file says that a material looks.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "craze/surface_mesh.h"
#include "craze/texture_wrap.h"

namespace craze {

/// A picture that a material reads at the first UVs.
struct LookPicture {
  std::shared_ptr<const std::string> bytes;  ///< of a PNG or JPEG; null: none here
  std::string file;                          ///< or another file, as the mesh's own names it
  /// 2 × 3: from (u, v, 1) of the mesh to the picture's (u, v), v upwards.
  Eigen::Matrix<double, 2, 3> place = Eigen::Matrix<double, 2, 3>::Identity();
  TextureWraps wraps{};

  explicit operator bool() const { return bytes || !file.empty(); }
};

struct MaterialLook;

/// A picture that a material reads at UVs of another set than the first.
struct FurtherPicture {
  LookPicture MaterialLook::*slot;  ///< what it is for
  LookPicture picture;
  std::size_t uv_set = 1;  ///< TEXCOORD_n
  float factor = 1;        ///< of a transmission picture
};

/// What a viewer shades with: each number is a factor of its picture, where there is one.
struct MaterialLook {
  /// What the colour's alpha does: nothing, cut out where it is below `alpha_cutoff`, or cover so
  /// much of what lies behind.
  enum class Alpha { ignored, cut, blended };

  Color base_color{1, 1, 1, 1};  ///< linear
  LookPicture base_picture;      ///< sRGB, and alpha
  Alpha alpha = Alpha::ignored;
  float alpha_cutoff = 0.5f;
  float transmission = 0;  ///< 0 … 1, part of the light that goes through, in the base colour
  LookPicture transmission_picture;        ///< red
  float metallic = 0, roughness = 0.8f;    ///< 0 … 1
  LookPicture metallic_roughness_picture;  ///< blue and green
  float normal_strength = 1;               ///< of the slopes
  LookPicture normal_picture;              ///< tangent space, green upwards
  float occlusion_strength = 1;            ///< 0 … 1
  LookPicture occlusion_picture;           ///< red
  Color emission{0, 0, 0, 1};              ///< linear, may be above 1
  LookPicture emission_picture;            ///< sRGB
  std::vector<FurtherPicture> further;     ///< those in other UV sets, in none of the above
};

/// All pictures of a look, some of which may not be there: for_each_picture(look, f) calls
/// f(picture).
template <class Look, class Do>
void for_each_picture(Look& look, Do f) {
  f(look.base_picture);
  f(look.transmission_picture);
  f(look.metallic_roughness_picture);
  f(look.normal_picture);
  f(look.occlusion_picture);
  f(look.emission_picture);
}

}  // namespace craze
