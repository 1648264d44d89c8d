// Things that lie on a surface and are no cracks: hairs, twigs, blades of grass, rods, pebbles,
// each with the shadow that it throws.
#pragma once

#include <vector>

#include "craze/base/random.h"
#include "craze/render/material/marks.h"

namespace craze {

/// Where a thing lies. Lengths in model units.
struct ThingPlace {
  render::Mark at;  ///< point, along, normal, depth
  double pixel;     ///< the size of a pixel there
  double size;      ///< of the picture, pixels
  Vec3 lamp;        ///< unit, towards the lamp
};

/// All numbers are drawn from `random`, in one order. Shadows come first.
std::vector<render::Mark> hair(const ThingPlace& place, Random& random);
std::vector<render::Mark> twig(const ThingPlace& place, Random& random);
std::vector<render::Mark> grass(const ThingPlace& place, Random& random);
std::vector<render::Mark> rod(const ThingPlace& place, Random& random);
std::vector<render::Mark> pebble(const ThingPlace& place, Random& random);

}  // namespace craze
