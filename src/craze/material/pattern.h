// What the ground of a surface bears that is no crack and may look like one: veins, courses of
// bricks, a coat that has flaked off in patches, specks of many colours.
#pragma once

#include "craze/material/rgb.h"

namespace craze::render {

/// Sizes are parts of the object's diagonal; a strength of 0 leaves the pattern out.
struct Pattern {
  float veins = 0;              ///< 0 … 1, how dark they are
  float vein_size = 0.03f;      ///< from one to the next
  float vein_width = 0.2f;      ///< 0 … 1, as part of that
  float bricks = 0;             ///< −1 … 1, how much darker, or lighter below 0, the mortar is
  float brick_size = 0.05f;     ///< height of a course; bricks are twice as long
  float mortar = 0.1f;          ///< 0 … 0.5, of a joint, as part of a course
  float flaking = 0;            ///< 0 … 1, share of the surface, about, where the coat is gone
  float flake_size = 0.03f;     ///< of a patch
  Rgb below = Rgb::Ones();      ///< factor of the colour there
  float specks = 0;             ///< 0 … 1, how much colours differ from speck to speck
  float speck_size = 0.002f;    ///< of a speck
  float angle = 0;              ///< by which bricks and veins are turned about z, radians
  Vec3f shift = Vec3f::Zero();  ///< added to places: other clouds, grains and patches
};

}  // namespace craze::render
