#include "craze/mesh/atlas/uv_atlas.h"

#include "craze/mesh/atlas/atlas_charts.h"
#include "craze/mesh/atlas/pack_charts.h"

namespace craze {

std::vector<Vec2> uv_atlas(const SurfaceMesh& mesh, const std::vector<char>& wanted,
                           const Context& context) {
  std::vector<AtlasChart> charts = atlas_charts(mesh, wanted, context);
  pack_charts(charts, context);
  std::vector<Vec2> uvs(3 * mesh.triangles.size(), Vec2::Zero());
  for (const AtlasChart& chart : charts) {
    for (std::size_t k = 0; k < chart.faces.size(); ++k) {
      const auto corner = 3 * static_cast<std::size_t>(chart.faces[k]);
      for (std::size_t i = 0; i < 3; ++i) uvs[corner + i] = chart.corners[k][i];
    }
  }
  return uvs;
}

}  // namespace craze
