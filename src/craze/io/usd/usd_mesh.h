// One Mesh prim of a USDA file.
#pragma once

#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/io/bytes/byte_sink.h"
#include "craze/io/usd/usd_materials.h"
#include "craze/mesh/morph_animation.h"
#include "craze/surface_mesh.h"

namespace craze {

/// How a clip runs in time codes: a key before the first stage and one after each.
struct UsdClip {
  double begin = 0;      ///< of the first stage
  double per_stage = 0;  ///< time codes
};

/// Passes on a Mesh as a child of the root, positions less `origin`, which is where it is placed.
/// `stages` lead to its positions; none: nothing moves. Throws Error(request) for coordinates
/// beyond single precision, and Cancelled.
void usd_mesh(const std::string& name, const SurfaceMesh& mesh, const Vec3& origin,
              const std::vector<MorphStage>& stages, const UsdClip& clip, UsdMaterials& materials,
              ByteSink& sink, const Context& context);

}  // namespace craze
