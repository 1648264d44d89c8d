#include "craze/scenario/outputs.h"

#include <optional>
#include <utility>

#include "craze/bake/nearby_cracks.h"
#include "craze/io/lines/write_lines.h"
#include "craze/io/write_mesh.h"
#include "craze/mesh/components.h"
#include "craze/mesh/transfer_attributes.h"
#include "craze/render/picture.h"
#include "craze/render/png.h"
#include "craze/scenario/fields.h"
#include "craze/scenario/growth_output.h"
#include "craze/scenario/load_surface.h"
#include "craze/scenario/network_lines.h"
#include "craze/scenario/output_surface.h"
#include "craze/scenario/shown_surface.h"
#include "craze/stats/statistics_report.h"

namespace craze {

namespace {

/// Whether anything is written that shows the mesh itself; a report only counts it.
bool shows_mesh(const RunRequest& request) {
  return !(request.output.empty() && request.picture.empty() && request.frames.empty() &&
           request.video.empty());
}

double total_length(const CrackNetwork& network) {
  double length = 0;
  for (const CrackEdge& e : network.edges) {
    length += (network.nodes[e.b].position - network.nodes[e.a].position).norm();
  }
  return length;
}

render::PictureOptions picture_options(const RunRequest& request) {
  render::PictureOptions options = request.shot;
  options.material = render::find_material(request.recipe.picture.material);
  options.view.up = request.recipe.picture.up;
  // Built-in shapes stand along z.
  if (options.view.up == render::UpAxis::automatic && is_shape(request.input)) {
    options.view.up = render::UpAxis::z;
  }
  return options;
}

void write_picture(const RunRequest& request, const ShownSurface& shown, const SurfaceMesh& surface,
                   const Simulation& simulation, const Context& context) {
  const render::PictureOptions options = picture_options(request);
  const TriangleMesh& mesh = simulation.mesh();
  SurfaceMesh drawn = shown.mesh;
  drawn.corner_normals =
      picture_normals(shown, surface, simulation, request.recipe.post, options.crease);
  const render::CrackLines lines = picture_lines(shown, mesh, render::line_reach(drawn, options));
  render::write_png(request.picture, render::render_picture(drawn, &lines, options, context));
}

/// The files that show how the cracks grow, and the mesh, which may be one of them.
void write_mesh_and_growth(const RunRequest& request, const ShownSurface& shown,
                           const SurfaceMesh& surface, const Simulation& simulation,
                           const CrackSites& sites, const CrackSchedule& schedule,
                           const Context& context) {
  const bool frames = !request.frames.empty() || !request.video.empty();
  std::optional<GrowthScene> scene;
  if (request.animate || frames)
    scene.emplace(request, simulation, surface, shown, sites, schedule);
  if (!request.output.empty()) {
    MorphAnimation animation;
    if (request.animate) animation = scene->animation();
    MeshFileOptions options;
    if (request.split_fragments) options.objects = "fragment";
    if (request.animate) options.animation = &animation;
    write_mesh(request.output, shown.mesh, options);
  }
  if (frames) scene->write_frames(picture_options(request), context);
}

}  // namespace

void write_outputs(const RunRequest& request, const SurfaceMesh& surface,
                   const Simulation& simulation, RunReport& report, const Context& context) {
  const TriangleMesh& mesh = simulation.mesh();
  const CrackNetwork network = simulation.network();
  const Components fragments = find_components(mesh);
  report.cracks = {simulation.events(), simulation.segments(), total_length(network),
                   fragments.count};
  const CrackSites sites = crack_sites(mesh);
  const CrackSchedule schedule = crack_schedule(mesh, sites, network);
  SurfaceMesh cut = shows_mesh(request) ? output_surface(surface, simulation, schedule, fragments)
                                        : transfer_attributes(surface, mesh);
  const ShownSurface shown = shown_surface(std::move(cut), simulation, request.recipe.post);
  report.output = count_mesh(shown.mesh);
  report.warnings.insert(report.warnings.end(), shown.warnings.begin(), shown.warnings.end());
  write_mesh_and_growth(request, shown, surface, simulation, sites, schedule, context);
  if (!request.lines.empty()) write_lines(request.lines, network_lines(network, surface));
  if (!request.fields.empty()) {
    const double radius = request.recipe.simulation.stress.curvature_radius;
    write_mesh(request.fields, field_mesh(simulation, radius, context));
  }
  if (!request.picture.empty()) write_picture(request, shown, surface, simulation, context);
  if (!request.report.empty() && !network.edges.empty()) {
    report.statistics = to_json(compute_with_sensitivity(graph_from_network(network, mesh)), {});
  }
}

}  // namespace craze
