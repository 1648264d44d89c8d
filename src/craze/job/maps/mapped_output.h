// A mesh whose materials carry the cracks, and not its triangles.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/products/maps/crack_pictures.h"
#include "craze/read_mesh.h"
#include "craze/report.h"

namespace craze {

struct MappedOutput {
  std::string path;  ///< .glb
  int size = 1024;   ///< texels along each side, at least; as many as the largest picture has
  PostParameters post;
  CrackStain stain;
};

/// Throws Error(request) for what came with a scene that is kept but has no UVs to map to.
void check_mappable(const SurfaceMesh& input, const SourceScene* scene);

/// Writes what was cracked, uncut, with the cracks in its materials' pictures: base colour, normal,
/// occlusion and roughness. That is `scene`, which came with the input, where it is glTF: its
/// geometry byte for byte. Of anything else it is what GLB makes of the surface, repaired; with UVs
/// made for it where it has none, or where they overlap and no picture needs them. Tells `warn` in
/// a sentence each what could not be done as asked. Throws what bake_maps() does, and
/// Error(output), Error(request).
MeshCounts write_mapped(const Result& result, const std::shared_ptr<const SourceScene>& scene,
                        const MappedOutput& output,
                        const std::function<void(const std::string&)>& warn,
                        const Context& context);

}  // namespace craze
