// A sample's surface with its cracks, as it is photographed and labelled.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/job/dataset/dataset_plan.h"
#include "craze/job/dataset/scene/crack_widths.h"
#include "craze/job/dataset/scene/projection.h"
#include "craze/job/dataset/scene/whole_cracks.h"
#include "craze/render/material/crack_lines.h"
#include "craze/render/picture.h"

namespace craze {

/// One picture's worth. A crack is the strip of the surface whose distance, along the surface, to
/// the nearest point of its centre line is at most half the width there: the picture draws it and
/// the labels measure it from the same segments.
struct Scene {
  /// How far from a crack's edge it is known to the points there, pixels in the middle.
  static constexpr double pixels_beside = 16;

  std::string object;  ///< the mesh, as errors name it
  Recipe recipe;
  Result result;
  SurfaceMesh mesh;  ///< drawn: cut and shut, with normals and fragments
  render::PictureOptions options;
  Projection projection;
  double pixel;                    ///< the side of a pixel in the middle of the picture, length
  std::vector<WholeCrack> cracks;  ///< none in a clean sample
  CrackWidths widths;              ///< of them, model units
  render::CrackLines lines;        ///< of `mesh`; widths in units of options.line_width
  std::vector<std::int32_t> crack_of_line;  ///< per segment of `lines`, index into cracks
};

/// The scene of some values of a plan. `name` seeds what is not drawn by the plan: the crack's
/// run, the places of marks. Cost: that of a run. Throws Error and Cancelled.
Scene make_scene(const Plan& plan, const PlanValues& values, const DatasetShape& shape,
                 const std::string& folder, std::uint64_t name, bool clean, const Context& context);

}  // namespace craze
