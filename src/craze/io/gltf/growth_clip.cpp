#include "craze/io/gltf/growth_clip.h"

#include <cstddef>

namespace craze {

namespace {

constexpr double wait_before = 0.25, wait_after = 1;  ///< seconds

}  // namespace

GrowthClipKeys growth_clip_keys(const MorphAnimation& animation) {
  const std::size_t stages = animation.stages.size();
  GrowthClipKeys keys;
  const auto add_key = [&](double seconds, std::size_t stages_done) {
    keys.seconds.push_back(static_cast<float>(seconds));
    for (std::size_t k = 0; k < stages; ++k) keys.weights.push_back(k < stages_done ? 0.0f : 1.0f);
  };
  const double each = animation.seconds / static_cast<double>(stages);
  add_key(0, 0);
  for (std::size_t k = 0; k <= stages; ++k) {
    add_key(wait_before + static_cast<double>(k) * each, k);
  }
  add_key(wait_before + animation.seconds + wait_after, stages);
  return keys;
}

}  // namespace craze
