#include "craze/job/crack_picture.h"

#include "craze/engine/cracked_surface.h"
#include "craze/engine/width_by_age.h"

namespace craze {

render::CrackLines picture_lines(const OpenedSurface& shown, const Result& result, double reach,
                                 const Context& context) {
  const TriangleMesh& mesh = shown.base(result);
  const std::vector<std::int32_t> sides = crack_sides(mesh);
  render::CrackLines lines = render::crack_lines(mesh, sides, reach, context);
  if (shown.shut) {
    const CrackedSurface& state = result.state();
    const WidthByAge by_age =
        width_by_age(result.report().recipe.post.late_width, state.network.edges);
    if (!by_age.all_alike()) {
      const std::vector<double> times = state.crack_times();
      std::vector<std::array<float, 2>> width;
      for (const std::int32_t side : sides) {
        const auto w = static_cast<float>(by_age.factor(times[mesh.crack_of(side)]));
        width.push_back({w, w});
      }
      render::set_widths(lines, sides, width);
    }
    return lines;
  }
  lines.open = true;
  lines.places = mesh.positions();
  return lines;
}

}  // namespace craze
