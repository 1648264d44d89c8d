// Maps as files, and what they mean beside them.
#pragma once

#include <string>
#include <vector>

#include "craze/context.h"
#include "craze/engine.h"
#include "craze/job/maps/scene_uvs.h"
#include "craze/maps.h"
#include "craze/products/maps/map_description.h"
#include "craze/surface_mesh.h"

namespace craze {

struct MapsRequest {
  std::string folder;  ///< made if need be; empty: no maps
  MapFormat format = MapFormat::png;
  MapOptions options;
};

/// Writes DIR/<map>.png or .exr, <map>.<UDIM>.… where there are tiles, <set>_<map>.… where there
/// are several sets, and maps.json last, each whole or not at all. Returns what bake_maps() does;
/// throws what it throws, and Error(output), Error(request) for more pieces or cracks than 16 bits
/// number.
std::vector<std::string> write_maps(const Result& result, const MapsRequest& request,
                                    const Context& context);
/// The same in the UVs that a kept scene has, or was given; maps.json says in which set.
std::vector<std::string> write_maps(const Result& result, const SceneUvs& uvs,
                                    const MapsRequest& request, const Context& context);
std::vector<std::string> write_maps(const SurfaceMesh& cracked, const MapsRequest& request,
                                    const Context& context);

}  // namespace craze
