// The keys of an animation in which cracks open one after the other.
#pragma once

#include <vector>

#include "craze/mesh/morph_animation.h"

namespace craze {

struct GrowthClipKeys {
  std::vector<float> seconds;  ///< ascending
  std::vector<float> weights;  ///< per key one for each stage: 1 before it, 0 after
};

/// Each stage's weight goes from 1 to 0 while the stage lasts; the clip waits before and after, so
/// that a loop shows both ends.
GrowthClipKeys growth_clip_keys(const MorphAnimation& animation);

}  // namespace craze
