// Making the figures of the paper, and the page that shows them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/job/figure_table.h"

namespace craze {

struct FigureRequest {
  std::string folder;                 ///< where the files go, made if need be
  std::string meshes;                 ///< where the user's meshes are; "": shapes only
  std::vector<std::string> settings;  ///< "key=value", on top of every recipe
  int size = 960;                     ///< longer side of the pictures, pixels
};

/// One picture or series of frames, and the run behind it.
struct FigurePart {
  std::string name;                   ///< of the figure, or of the recipe where it has several
  std::vector<std::string> pictures;  ///< files in the folder
  std::string command;                ///< what makes the same picture
  std::int64_t triangles = 0;         ///< of the simulation mesh, before the first crack
  double seconds = 0;                 ///< of the run without its picture
  std::vector<std::string> warnings;  ///< of its report, each after its name
};

struct FigureResult {
  const Figure* figure;
  bool stands_in = false;  ///< a shape stands for a mesh that was not there
  std::vector<FigurePart> parts;
  bool cancelled = false;
};

/// Makes one figure: NAME.png, or RECIPE.png where there are several, RECIPE.json with the report;
/// frames in the folder NAME; a diagram as NAME.svg. Throws Error as run() does.
FigureResult make_figure(const Figure& figure, const FigureRequest& request,
                         const Context& context);

/// Markdown: a table of what was made (triangles and time here and in the paper, command), then the
/// pictures, each under its figure's title. Says where a shape stands in.
std::string figure_page(const std::vector<FigureResult>& results);

}  // namespace craze
