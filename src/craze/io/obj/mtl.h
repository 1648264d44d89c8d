// Wavefront's material libraries.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "craze/io/obj/mtl_lines.h"
#include "craze/surface_mesh.h"

namespace craze {

/// What is understood of a material; all else is kept as text.
struct MtlMaterial {
  std::string name;
  std::array<double, 3> color{0.8, 0.8, 0.8};  ///< Kd, linear, 0 … 1
  double opacity = 1;                          ///< d, or 1 − Tr
  std::array<double, 3> emission{0, 0, 0};     ///< Ke, linear, 0 or more
  double roughness = 0.8, metallic = 0;        ///< Pr, Pm
  MtlPicture color_picture;                    ///< map_Kd
  MtlPicture normal_picture;                   ///< norm
  MtlPicture emission_picture;                 ///< map_Ke
  /// Keywords of lines that say something else, each once, but for the light that surrounds (Ka,
  /// Ni, illum, sharpness) and for what is nothing: numbers that are all 0.
  std::vector<std::string> others;
  bool has_unknown_color = false;  ///< its Kd is no colour, or a file of a spectrum
  bool is_bounded = false;         ///< some number of its lay outside its bounds
};

/// Lines that say nothing that can be understood are passed over. Keywords may be in capitals.
std::vector<MtlMaterial> parse_mtl(std::string_view text);

/// A name as it may end a line of OBJ and MTL: without line ends, nor a backslash at its end, which
/// would join the next line to it.
std::string one_line_name(std::string name);

/// What the materials of a mesh are called: one line each, and no two alike.
std::vector<std::string> mtl_names(const SurfaceMesh& mesh);

/// The text with `rename` applied to the name of every picture, as it stands there.
std::string rename_pictures(std::string_view text,
                            const std::function<std::string(const std::string&)>& rename);

}  // namespace craze
