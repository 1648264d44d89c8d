// Mud with smooth lines on a built-in shape, with settings of a test's own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "craze/engine.h"
#include "craze/presets.h"
#include "craze/shapes.h"
#include "recipe_with.h"

namespace craze::test {

inline const char* const plate = "plate?n=40&jitter=0.3";

inline Result mud_run(const std::string& shape, const std::vector<std::string>& settings,
                      int threads = 1) {
  Recipe recipe = read_preset("mud");
  recipe.simulation.layer.spacing = 0.14;
  recipe.post.relative_roughness = 0;
  Context context;
  context.threads = threads;
  return crack({std::make_shared<SurfaceMesh>(make_shape(shape)), {}, shape},
               recipe_with(settings, recipe), {}, context);
}

}  // namespace craze::test
