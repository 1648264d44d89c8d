// The figures of the paper: what is cracked, by which recipe, and what the paper says of its own.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "craze/presets.h"

namespace craze {

enum class FigureKind {
  picture,  ///< one picture per recipe
  frames,   ///< pictures of the growth
  diagram,  ///< drawn from mesh states; nothing is simulated
};

struct Figure {
  int number;              ///< in the paper
  std::string_view name;   ///< on the command line and of its files
  std::string_view title;  ///< one line
  FigureKind kind = FigureKind::picture;
  std::vector<std::string_view> recipes = {};  ///< names of figure_recipes(), one per picture
  std::string_view mesh = {};   ///< file in the user's folder; "": the built-in shape is the thing
  std::string_view shape = {};  ///< what stands in where the file is not there
  double azimuth = 0;           ///< of the camera, degrees
  double elevation = 18;        ///< degrees above the horizon
  double aspect = 0.75;         ///< of the picture: height over width
  int paper_triangles = 0;      ///< 0: none
  std::string_view paper_time = {};  ///< as its caption says it; "": none
};

/// All of them, in the paper's order.
const std::vector<Figure>& figure_table();

/// By name or number; Error(usage) naming the nearest where there is none.
const Figure& find_figure(const std::string& name_or_number);

/// The embedded text of a recipe that the table names.
const Preset& find_figure_recipe(std::string_view name);

}  // namespace craze
