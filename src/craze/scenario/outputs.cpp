#include "craze/scenario/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "craze/bake/nearby_cracks.h"
#include "craze/io/write_lines.h"
#include "craze/io/write_mesh.h"
#include "craze/mesh/components.h"
#include "craze/post/opening.h"
#include "craze/render/picture.h"
#include "craze/render/png.h"
#include "craze/scenario/fields.h"
#include "craze/scenario/load_surface.h"
#include "craze/scenario/network_lines.h"
#include "craze/scenario/opened_surface.h"
#include "craze/scenario/output_surface.h"
#include "craze/stats/statistics_report.h"

namespace craze {

namespace {

double total_length(const CrackNetwork& network) {
  double length = 0;
  for (const CrackEdge& e : network.edges) {
    length += (network.nodes[e.b].position - network.nodes[e.a].position).norm();
  }
  return length;
}

bool opens(const PostParameters& post) {
  return post.gap != 0 || post.wall != 0 || post.curl != 0;
}

/// Whether anything asked for, or the count of its triangles, needs the surface itself.
bool shows_surface(const RunRequest& request) {
  return !request.output.empty() || !request.picture.empty() || !request.frames.empty() ||
         opens(request.recipe.post);
}

/// The mesh that is shown: cut, and opened where the recipe asks for it.
SurfaceMesh shown_surface(const SurfaceMesh& cut_surface, const Simulation& simulation,
                          const Recipe& recipe) {
  const PostParameters& post = recipe.post;
  if (!opens(post)) return cut_surface;
  const TriangleMesh& mesh = simulation.mesh();
  std::vector<Vec3> displacement(static_cast<std::size_t>(mesh.vertex_count()));
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    displacement[v] = simulation.field().displacement(v);
  }
  OpeningOptions options;
  options.gap = post.gap;
  options.wall = post.wall;
  options.curl = post.curl;
  const OpenedMesh opened = open_cracks(mesh, displacement, options);
  return opened_surface(cut_surface, mesh, opened, post.curl == 0);
}

render::PictureOptions picture_options(const RunRequest& request) {
  render::PictureOptions options;
  options.material = render::find_material(request.recipe.picture.material);
  options.view.up = request.recipe.picture.up;
  // Built-in shapes stand along z.
  if (options.view.up == render::UpAxis::automatic && is_shape(request.input)) {
    options.view.up = render::UpAxis::z;
  }
  return options;
}

void write_picture(const RunRequest& request, const SurfaceMesh& shown,
                   const Simulation& simulation, const Context& context) {
  const render::PictureOptions options = picture_options(request);
  const TriangleMesh& mesh = simulation.mesh();
  // Opened cracks are seen by their gaps and walls.
  const bool shut = request.recipe.post.gap == 0;
  render::CrackLines lines;
  if (shut) {
    lines = render::crack_lines(mesh, crack_sides(mesh), render::line_reach(shown, options));
  }
  const bool matches = shown.triangles.size() == static_cast<std::size_t>(mesh.face_count());
  render::write_png(
      request.picture,
      render::render_picture(shown, shut && matches ? &lines : nullptr, options, context));
}

/// Pictures of the shut cracks at equal steps of time, from none to all.
void write_frames(const RunRequest& request, const SurfaceMesh& cut, const Simulation& simulation,
                  const Context& context) {
  const render::PictureOptions options = picture_options(request);
  const TriangleMesh& mesh = simulation.mesh();
  const std::vector<std::int32_t> sides = crack_sides(mesh);
  const std::vector<double> times = simulation.crack_times();
  const double end = times.empty() ? 0 : *std::max_element(times.begin(), times.end());
  std::filesystem::create_directories(request.frames);
  for (int i = 0; i < request.frame_count; ++i) {
    const double share = request.frame_count > 1 ? i / (request.frame_count - 1.0) : 1;
    context.report({"frames", share, simulation.events(), mesh.face_count(), simulation.load()});
    std::vector<std::int32_t> open;
    for (const std::int32_t h : sides) {
      const double time = times[mesh.crack_of(h)];
      if (share > 0 && time <= share * end) open.push_back(h);
    }
    const render::CrackLines lines =
        render::crack_lines(mesh, open, render::line_reach(cut, options));
    const auto path = std::filesystem::path(request.frames) / fmt::format("frame_{:04}.png", i);
    render::write_png(path.string(), render::render_picture(cut, &lines, options, context));
  }
}

}  // namespace

void write_outputs(const RunRequest& request, const SurfaceMesh& surface,
                   const Simulation& simulation, RunReport& report, const Context& context) {
  const TriangleMesh& mesh = simulation.mesh();
  const CrackNetwork network = simulation.network();
  const Components fragments = find_components(mesh);
  report.cracks = {simulation.events(), simulation.segments(), total_length(network),
                   fragments.count};
  SurfaceMesh cut, shown;
  if (shows_surface(request)) {
    cut = output_surface(surface, simulation, fragments);
    shown = shown_surface(cut, simulation, request.recipe);
    report.output = count_mesh(shown);
  } else {
    report.output = {mesh.vertex_count(), mesh.face_count()};
  }
  if (!request.output.empty()) write_mesh(request.output, shown);
  if (!request.lines.empty()) write_lines(request.lines, network_lines(network, surface));
  if (!request.fields.empty()) {
    const double radius = request.recipe.simulation.stress.curvature_radius;
    write_mesh(request.fields, field_mesh(simulation, radius, context));
  }
  if (!request.picture.empty()) write_picture(request, shown, simulation, context);
  if (!request.frames.empty()) write_frames(request, cut, simulation, context);
  if (!request.report.empty() && !network.edges.empty()) {
    report.statistics = to_json(compute_with_sensitivity(graph_from_network(network, mesh)), {});
  }
}

}  // namespace craze
