// Painted multipliers of material and layer, and where painting forbids cracks.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/model/sources/input_fields.h"
#include "craze/parameters.h"

namespace craze {

/// A factor everywhere: the attribute times the picture, 1 where neither is asked for.
struct PaintedMultiplier {
  std::vector<double> face;    ///< #F, ≥ 0
  std::vector<double> vertex;  ///< #V, ≥ 0
};

/// Factors of toughness and strength: material.attribute and material.texture. Throws as the
/// functions of input_fields.h do, and Error(request) for a negative factor.
PaintedMultiplier material_multiplier(const TriangleMesh& mesh, const MaterialParameters& material,
                                      const InputFields& fields);
/// Factors of the spacing (of ℓ, that is): layer.attribute and layer.texture.
PaintedMultiplier spacing_multiplier(const TriangleMesh& mesh, const LayerParameters& layer,
                                     const InputFields& fields);

/// #F, 1 where no crack may ever run, because a painted multiplier is zero there: the attribute of
/// material or layer at the face or a corner, or a pixel of the picture of stress, material or
/// layer that counts at the face's middle or at a corner. So what is mixed from zero and more is
/// not weak ground beside the zero, but part of it. The attribute of stress is added, not
/// multiplied: its zeros count where it is the only source of stress (`parameters.stress` is zero
/// otherwise, and there is no impact, shrinkage or growth).
std::vector<std::uint8_t> forbidden_faces(const TriangleMesh& mesh,
                                          const SimulationParameters& parameters,
                                          const InputFields& fields);

/// The same for the attributes of material and layer alone: what is to be found on the input's own
/// triangles before a finer mesh mixes their corners' values.
std::vector<std::uint8_t> faces_with_zero_attribute(const TriangleMesh& mesh,
                                                    const SimulationParameters& parameters,
                                                    const InputFields& fields);

}  // namespace craze
