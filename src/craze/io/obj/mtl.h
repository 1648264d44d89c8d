// Wavefront's material libraries.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

/// What is understood of a material; all else is kept as text.
struct MtlMaterial {
  std::string name;
  std::array<double, 3> color{0.8, 0.8, 0.8};      ///< Kd
  double opacity = 1;                              ///< d, or 1 − Tr
  std::string color_picture;                       ///< map_Kd, as the file names it; "" without
  std::array<double, 2> scale{1, 1}, shift{0, 0};  ///< of the picture's UVs: -s, then -o
  bool is_clamped = false;                         ///< -clamp: it does not repeat
};

/// Lines that say something else, or nothing that can be understood, are passed over.
std::vector<MtlMaterial> parse_mtl(std::string_view text);

/// What the materials of a mesh are called: one line each, and no two alike.
std::vector<std::string> mtl_names(const SurfaceMesh& mesh);

/// The text with `rename` applied to the name of every picture.
std::string rename_pictures(std::string_view text,
                            const std::function<std::string(const std::string&)>& rename);

}  // namespace craze
