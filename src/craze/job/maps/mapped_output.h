// A mesh whose materials carry the cracks, and not its triangles.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/job/maps/scene_uvs.h"
#include "craze/products/maps/pictures/crack_pictures.h"
#include "craze/read_mesh.h"
#include "craze/report.h"

namespace craze {

struct MappedOutput {
  std::string path;  ///< .glb
  int size = 1024;   ///< texels along each side, at least; as many as the largest picture has
  PostParameters post;
  CrackStain stain;
};

/// Writes what was cracked, uncut, with the cracks in its materials' pictures: base colour, normal,
/// occlusion and roughness. That is the scene that came with the input, where it is glTF (`uvs`):
/// its geometry byte for byte but for the UV set that was made, pictures of other sets laid out in
/// it, and what no crack touches as it was. Of anything else (`uvs` null) it is what GLB makes of
/// the surface, repaired, and what it can of `scene`; with UVs made for it where it has none, or
/// where they overlap and no picture needs them. Tells `warn` in a sentence each what could not be
/// done as asked. Throws what bake_maps() does, and Error(output), Error(request).
MeshCounts write_mapped(const Result& result, const SceneUvs* uvs,
                        const std::shared_ptr<const SourceScene>& scene, const MappedOutput& output,
                        const std::function<void(const std::string&)>& warn,
                        const Context& context);

}  // namespace craze
