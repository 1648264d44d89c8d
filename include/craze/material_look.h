// How a file says that a material looks.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "craze/surface_mesh.h"

namespace craze {

/// The base colour: the factor, times the texture where there is one.
struct MaterialLook {
  /// What the colour's alpha does: nothing, cut out where it is below `alpha_cutoff`, or cover so
  /// much of what lies behind.
  enum class Alpha { ignored, cut, blended };

  Color base_color{1, 1, 1, 1};                ///< linear
  std::shared_ptr<const std::string> texture;  ///< the bytes of a PNG or JPEG; null: none here
  std::string texture_file;                    ///< or another file, as the mesh's own names it
  /// 2 × 3: from (u, v, 1) of the mesh to the texture's (u, v), v upwards.
  Eigen::Matrix<double, 2, 3> texture_place = Eigen::Matrix<double, 2, 3>::Identity();
  Alpha alpha = Alpha::ignored;
  float alpha_cutoff = 0.5f;
  float transmission = 0;  ///< 0 … 1, part of the light that goes through, in the base colour
};

}  // namespace craze
