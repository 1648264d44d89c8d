#include "craze/mesh/morph_animation.h"

namespace craze {

std::vector<MorphStage> stages_of(const MorphAnimation& animation,
                                  const std::vector<std::int32_t>& vertices) {
  std::vector<MorphStage> stages;
  for (const MorphStage& stage : animation.stages) {
    MorphStage& own = stages.emplace_back();
    std::size_t i = 0;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      while (i < stage.vertices.size() && stage.vertices[i] < vertices[v]) ++i;
      if (i == stage.vertices.size()) break;
      if (stage.vertices[i] != vertices[v]) continue;
      own.vertices.push_back(static_cast<std::int32_t>(v));
      own.shifts.push_back(stage.shifts[i]);
    }
  }
  return stages;
}

}  // namespace craze
