// How a surface and its cracks look.
#pragma once

#include <string>
#include <vector>

#include "craze/material/pattern.h"
#include "craze/material/rgb.h"

namespace craze::render {

struct Material {
  std::string name;
  Rgb color{0.5f, 0.5f, 0.5f};    ///< diffuse reflectance
  Rgb wall{0.3f, 0.3f, 0.3f};     ///< diffuse reflectance of faces in the slot "crack_wall"
  float mottle = 0;               ///< relative strength of the cloudy variation of the colour
  float bump = 0;                 ///< 0 … 1, small unevenness of the surface
  float grit = 0;                 ///< 0 … 1, grains: fine spots and pits
  float aggregate = 0;            ///< 0 … 1, stones of different tints
  float aggregate_size = 0.011f;  ///< of a stone, as part of the object's diagonal
  Pattern pattern{};              ///< of the ground
  float pieces = 0;               ///< 0 … 1, how much one fragment differs from the next
  float coat = 0;                 ///< 0 … 1, how much of a clear, smooth coat lies on top
  float gloss = 0;                ///< strength of a broad sheen, for rough surfaces
  bool glass = false;             ///< clear: the colour is what one layer lets through
  float fissure = 0;              ///< glass: how deep cracks go, as part of the object's diagonal
  Rgb line{0.02f, 0.02f, 0.02f};  ///< colour in the core of a crack line
  float line_strength = 1;        ///< 0 … 1, how much of the core colour is seen
  float patchiness = 0;           ///< 0 … 1, how much that varies along a line
  float stain = 0;                ///< 0 … 1, darkening of the faint band beside a line
  float groove = 0;               ///< 0 … 1, how deep the lines look engraved
  float worn = 0;                 ///< about 0 … 1, how round the edges of open cracks are
  Rgb backdrop = from_srgb(186, 187, 190);  ///< a background it looks good against
};

/// clay, mud, glaze, plaster, glass, paint.
const std::vector<Material>& materials();

/// The material of that name; throws Error(usage) listing the names.
const Material& find_material(const std::string& name);

}  // namespace craze::render
