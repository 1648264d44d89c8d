// The pictures of a material, as glTF has them.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "craze/base/image.h"
#include "craze/texture_wrap.h"

namespace craze {

/// A picture and how it lies on the UVs. First row at the top, v = 1.
struct SurfacePicture {
  Image image;
  /// From (u, v, 1) of the mesh to the picture's (u, v).
  Eigen::Matrix<double, 2, 3> place = Eigen::Matrix<double, 2, 3>::Identity();
  TextureWraps wraps{};    ///< of the picture's u and v
  std::size_t uv_set = 0;  ///< of the mesh
};

/// What a picture holds is multiplied by its factor.
struct SurfacePictures {
  SurfacePicture base_color;  ///< sRGB; empty: white
  SurfacePicture normal;      ///< in tangent space, ½ + ½ n, green up; empty: flat
  SurfacePicture occlusion;   ///< red: light that comes in; empty: 1
  SurfacePicture roughness;   ///< green: roughness, blue: metal; empty: 1 and 1
  double normal_scale = 1;    ///< of its red and green
  double occlusion_strength = 1;
  double roughness_factor = 1, metallic_factor = 1;
};

}  // namespace craze
