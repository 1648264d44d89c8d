#include "craze/job/outputs.h"

#include <functional>
#include <optional>
#include <utility>

#include "craze/engine/cracked_surface.h"
#include "craze/io/files/extension.h"
#include "craze/io/lines/write_lines.h"
#include "craze/job/crack_picture.h"
#include "craze/job/growth_frames.h"
#include "craze/job/maps/mapped_output.h"
#include "craze/job/maps/scene_uvs.h"
#include "craze/mesh/corners_on_surface.h"
#include "craze/mesh/morph_animation.h"
#include "craze/output/lost_data.h"
#include "craze/output/write_surface.h"
#include "craze/products.h"
#include "craze/products/cut_surface.h"
#include "craze/products/field_mesh.h"
#include "craze/products/growth/growth.h"
#include "craze/products/opening/opened_origin.h"
#include "craze/products/opening/shading_normals.h"
#include "craze/products/statistics/graph/graph_input.h"
#include "craze/recipe/own_lengths.h"
#include "craze/render/picture.h"
#include "craze/render/png.h"
#include "craze/write_mesh.h"

namespace craze {

namespace {

/// Those at the corners of the surface that is shown.
std::vector<std::vector<Vec2>> shown_uvs(std::vector<std::vector<Vec2>> sets, const Result& result,
                                         const OpenedSurface& shown) {
  if (sets.empty()) return sets;
  const SurfaceOrigin origin = opened_origin(result, shown);
  for (std::vector<Vec2>& uvs : sets) {
    if (!uvs.empty()) uvs = uvs_on_surface(uvs, origin);
  }
  return sets;
}

/// Whether anything is written that shows the mesh itself; a report only counts it.
bool shows_mesh(const RunRequest& request) {
  const bool is_cut = !request.output.empty() && !request.as_maps;
  return is_cut || !(request.picture.empty() && request.frames.empty() && request.video.empty());
}

render::PictureOptions picture_options(const RunRequest& request, const Yardstick& yardstick,
                                       const BesideSurface& beside) {
  render::PictureOptions options = request.shot;
  options.line_width = own_length(request.line_width, yardstick, "--line-width");
  options.looks = beside.looks;
  options.environment.environment = beside.environment;
  options.material = render::find_material(request.recipe.picture.material);
  options.view.up = request.recipe.picture.up;
  // Built-in shapes stand along z.
  if (options.view.up == UpAxis::automatic && is_shape(request.input)) {
    options.view.up = UpAxis::z;
  }
  return options;
}

void write_picture(const RunRequest& request, render::PictureOptions options,
                   const OpenedSurface& shown, const Result& result, const Context& context) {
  SurfaceMesh drawn = shown.mesh;
  options.subject = render::subject_of(drawn);
  drawn.corner_normals = shading_normals(shown, result, options.crease);
  const render::CrackLines lines =
      picture_lines(shown, result, render::line_reach(drawn, options), context);
  render::write_png(request.picture, render::render_picture(drawn, &lines, options, context),
                    context);
}

/// The files that show how the cracks grow, and the mesh, which may be one of them.
void write_mesh_and_growth(const RunRequest& request, const OpenedSurface& shown,
                           const Result& result, const SourceFile& source,
                           const render::PictureOptions& picture, Report& report,
                           const Context& context) {
  const bool frames = !request.frames.empty() || !request.video.empty();
  std::optional<Growth> growth;
  if (request.animate || frames) growth.emplace(result, shown);
  context.check();
  if (!request.output.empty() && !request.as_maps) {
    MorphAnimation animation;
    if (request.animate) {
      animation = growth->animation(request.animation_stages, request.clip_seconds, context);
    }
    SurfaceFileOptions options;
    options.crease = picture.crease;
    if (request.split_fragments) options.objects = "fragment";
    if (request.animate) options.animation = &animation;
    options.warn = [&report](const std::string& warning) { report.warnings.push_back(warning); };
    write_surface(request.output, shown.mesh, shown, result, source, options, context);
  }
  if (frames) {
    write_frames(request, {result, shown, *growth}, picture, context);
  }
}

/// The UVs that maps of a kept scene lie in; none: there are no maps, or the scene is not kept.
std::optional<SceneUvs> uvs_of_scene(const RunRequest& request, const Result& result,
                                     const SourceFile& source,
                                     const std::function<void(const std::string&)>& warn,
                                     const Context& context) {
  if (request.maps.folder.empty() && !request.as_maps) return {};
  const auto document = std::dynamic_pointer_cast<const GltfDocument>(source.scene);
  if (!document) return {};
  SceneUvs uvs = scene_uvs(result, document, !request.as_maps, context);
  if (uvs.warning.empty()) return uvs;
  const bool is_written = lower_extension(request.output) == ".glb";
  warn(uvs.warning + (is_written ? "" : "; -o FILE.glb writes the scene with them"));
  return uvs;
}

}  // namespace

std::optional<StatisticsWithSensitivity> write_outputs(const RunRequest& request,
                                                       const Result& result,
                                                       const BesideSurface& beside, Report& report,
                                                       const Context& context) {
  render::PictureOptions picture = picture_options(request, result.state().run->yardstick, beside);
  const auto warn = [&report](const std::string& warning) { report.warnings.push_back(warning); };
  const std::optional<SceneUvs> uvs = uvs_of_scene(request, result, beside.source, warn, context);
  SourceFile source = beside.source;
  if (uvs && lower_extension(request.output) == ".glb") source.scene = uvs->document;
  GrowthTimes times = growth_times(result);
  SurfaceMesh cut = shows_mesh(request) ? cut_surface(result, times, context)
                                        : plain_cut_surface(result, context.threads);
  context.check();
  const OpenedSurface shown = opened_surface(result, std::move(cut), std::move(times),
                                             result.report().recipe.post, context);
  if (takes_pictures(request)) picture.further_uvs = shown_uvs(beside.further_uvs, result, shown);
  report.output = count_mesh(shown.mesh);
  if (shows_mesh(request)) {
    report.warnings.insert(report.warnings.end(), shown.warnings.begin(), shown.warnings.end());
  }
  write_mesh_and_growth(request, shown, result, source, picture, report, context);
  context.check();
  if (!request.lines.empty()) {
    write_lines(request.lines, crack_lines(result, context), warn, context);
  }
  context.check();
  if (!request.maps.folder.empty()) {
    MapsRequest maps = request.maps;
    maps.options.post = result.report().recipe.post;
    const std::vector<std::string> warnings =
        uvs ? write_maps(result, *uvs, maps, context) : write_maps(result, maps, context);
    report.warnings.insert(report.warnings.end(), warnings.begin(), warnings.end());
  }
  context.check();
  if (request.as_maps) {
    const Recipe& recipe = result.report().recipe;
    const std::string scaled =
        describe_unit(metres_per_unit(*result.state().surface, recipe), "glb");
    if (!scaled.empty()) warn(scaled);
    const MappedOutput mapped{request.output, request.maps.options.size, recipe.post,
                              request.stain};
    report.output =
        write_mapped(result, uvs ? &*uvs : nullptr, beside.source.scene, mapped, warn, context);
  }
  context.check();
  if (!request.fields.empty()) write_mesh(request.fields, field_mesh(result, context), {}, context);
  context.check();
  if (!request.picture.empty()) write_picture(request, picture, shown, result, context);
  context.check();
  const CrackedSurface& state = result.state();
  if (request.report.empty() || state.network.edges.empty()) return {};
  StatisticsOptions options;
  options.bootstrap.context = context;
  return compute_with_sensitivity(graph_from_network(state.network, state.mesh()), options);
}

}  // namespace craze
