// A mesh that moves, its triangles staying what they are.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/tensor.h"

namespace craze {

/// What moves during one part of a clip, at a constant speed.
struct MorphStage {
  std::vector<std::int32_t> vertices;  ///< ascending
  std::vector<Vec3> shifts;            ///< of these, model units
};

/// The clip ends at the positions of the mesh that it belongs to; the stages, all of one length,
/// lead there.
struct MorphAnimation {
  double seconds = 0;
  std::vector<MorphStage> stages;
};

/// The stages as a part of the mesh sees them: `vertices`, ascending, are those of the whole mesh.
std::vector<MorphStage> stages_of(const MorphAnimation& animation,
                                  const std::vector<std::int32_t>& vertices);

}  // namespace craze
