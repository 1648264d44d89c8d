#include "craze/job/maps/made_uvs.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "craze/base/text/format.h"
#include "craze/engine/cracked_surface.h"
#include "craze/mesh/atlas/uv_atlas.h"
#include "craze/mesh/uv_islands.h"

namespace craze {

std::string make_uvs(SurfaceMesh& surface, const std::string& reason, const Context& context) {
  surface.corner_uvs = uv_atlas(surface, {}, context);
  const std::vector<std::int32_t> islands = uv_islands(surface);
  return fmt::format("the mesh {} (maps): others were made for it, in {} islands", reason,
                     islands.empty() ? 0 : 1 + *std::max_element(islands.begin(), islands.end()));
}

Result with_made_uvs(const Result& result, std::string& told, const Context& context) {
  auto state = std::make_shared<CrackedSurface>(result.state());
  SurfaceMesh surface = *state->surface;
  told = make_uvs(surface, "has no UVs", context);
  state->surface = std::make_shared<const SurfaceMesh>(std::move(surface));
  return {std::move(state), result.report()};
}

}  // namespace craze
