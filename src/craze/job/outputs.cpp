#include "craze/job/outputs.h"

#include <optional>
#include <utility>

#include "craze/engine/cracked_surface.h"
#include "craze/io/lines/write_lines.h"
#include "craze/job/crack_picture.h"
#include "craze/job/growth_frames.h"
#include "craze/job/load_surface.h"
#include "craze/mesh/morph_animation.h"
#include "craze/products/crack_lines.h"
#include "craze/products/cut_surface.h"
#include "craze/products/field_mesh.h"
#include "craze/products/growth/growth.h"
#include "craze/products/statistics/graph/graph_input.h"
#include "craze/render/picture.h"
#include "craze/render/png.h"
#include "craze/write_mesh.h"

namespace craze {

namespace {

/// Whether anything is written that shows the mesh itself; a report only counts it.
bool shows_mesh(const RunRequest& request) {
  return !(request.output.empty() && request.picture.empty() && request.frames.empty() &&
           request.video.empty());
}

render::PictureOptions picture_options(const RunRequest& request) {
  render::PictureOptions options = request.shot;
  options.material = render::find_material(request.recipe.picture.material);
  options.view.up = request.recipe.picture.up;
  // Built-in shapes stand along z.
  if (options.view.up == UpAxis::automatic && is_shape(request.input)) {
    options.view.up = UpAxis::z;
  }
  return options;
}

void write_picture(const RunRequest& request, const OpenedSurface& shown, const Result& result,
                   const Context& context) {
  const render::PictureOptions options = picture_options(request);
  SurfaceMesh drawn = shown.mesh;
  drawn.corner_normals = picture_normals(shown, result, request.recipe.post, options.crease);
  const render::CrackLines lines =
      picture_lines(shown, result, render::line_reach(drawn, options), context);
  render::write_png(request.picture, render::render_picture(drawn, &lines, options, context),
                    context);
}

/// The files that show how the cracks grow, and the mesh, which may be one of them.
void write_mesh_and_growth(const RunRequest& request, const OpenedSurface& shown,
                           const Result& result, const GrowthTimes& times, Report& report,
                           const Context& context) {
  const bool frames = !request.frames.empty() || !request.video.empty();
  std::optional<Growth> growth;
  if (request.animate || frames) growth.emplace(result, times, shown);
  context.check();
  if (!request.output.empty()) {
    MorphAnimation animation;
    if (request.animate) {
      animation = growth->animation(request.animation_stages, request.clip_seconds, context);
    }
    MeshFileOptions options;
    if (request.split_fragments) options.objects = "fragment";
    if (request.animate) options.animation = &animation;
    options.warn = [&report](const std::string& warning) { report.warnings.push_back(warning); };
    write_mesh(request.output, shown.mesh, options, context);
  }
  if (frames) {
    write_frames(request, {result, times, shown, *growth}, picture_options(request), context);
  }
}

}  // namespace

std::optional<StatisticsWithSensitivity> write_outputs(const RunRequest& request,
                                                       const Result& result, Report& report,
                                                       const Context& context) {
  const GrowthTimes times = growth_times(result);
  SurfaceMesh cut =
      shows_mesh(request) ? cut_surface(result, times, context) : plain_cut_surface(result);
  context.check();
  const OpenedSurface shown = opened_surface(result, std::move(cut), request.recipe.post, context);
  report.output = count_mesh(shown.mesh);
  report.warnings.insert(report.warnings.end(), shown.warnings.begin(), shown.warnings.end());
  write_mesh_and_growth(request, shown, result, times, report, context);
  context.check();
  if (!request.lines.empty()) write_lines(request.lines, crack_lines(result, context), context);
  context.check();
  if (!request.fields.empty()) write_mesh(request.fields, field_mesh(result, context), {}, context);
  context.check();
  if (!request.picture.empty()) write_picture(request, shown, result, context);
  context.check();
  const CrackedSurface& state = result.state();
  if (request.report.empty() || state.network.edges.empty()) return {};
  StatisticsOptions options;
  options.bootstrap.context = context;
  return compute_with_sensitivity(graph_from_network(state.network, state.simulation->mesh()),
                                  options);
}

}  // namespace craze
