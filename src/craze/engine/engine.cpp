#include "craze/engine.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <numeric>

#include "craze/engine/asset/keep_to_planes.h"
#include "craze/engine/check_where.h"
#include "craze/engine/cracked_surface.h"
#include "craze/engine/place_impacts.h"
#include "craze/engine/run_outcome.h"
#include "craze/engine/spacing_rounds.h"
#include "craze/error.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/mesh/repair/traced_repair.h"
#include "craze/recipe/check_recipe.h"
#include "craze/recipe/length_text.h"
#include "craze/recipe/own_lengths.h"

namespace craze {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TracedSurface repaired(const Input& input, Report& report, const Context& context) {
  TracedSurface traced = traced_repair(*input.surface, {}, report.repair, context);
  if (traced.surface.triangles.empty()) {
    throw Error(ErrorKind::input, "nothing to crack", input.name,
                "the mesh has no triangle with area");
  }
  return traced;
}

void warn_of_unused_unit(Report& report, const SurfaceMesh& surface) {
  const double given = metres(report.recipe.mesh.unit);
  if (given == 0 || surface.metres_per_unit == 0 || given == surface.metres_per_unit) return;
  report.warnings.push_back("the file says its own unit, which stands (mesh.unit)");
}

CarriedCounts count_carried(const CutAsset& cut, std::size_t triangles_before) {
  CarriedCounts counts;
  counts.split_triangles = cut.report.split_faces;
  counts.added_triangles = std::ssize(cut.triangles) - static_cast<std::int64_t>(triangles_before);
  counts.rerouted_pieces = cut.report.traced.rerouted;
  counts.lost_pieces = cut.report.traced.lost + cut.report.lost_segments;
  counts.lost_length = cut.report.traced.lost_length;
  return counts;
}

/// Puts the cracks of a finished run into the mesh that products speak of.
void settle(CrackedSurface& state, SimulationSurface surface, Report& report,
            const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  const Simulation& simulation = *state.simulation;
  state.network = crack_network(simulation);
  state.fragments = find_components(simulation.mesh());
  resolve_roughness(state.recipe.post, state.network);
  const bool is_rough = state.recipe.post.roughness > 0;
  const bool on_itself = surface.asset.triangles.empty();
  if (on_itself && !is_rough) {
    state.surface = std::move(surface.mesh);
    return;
  }
  Context counting = context;
  counting.progress = [&](Progress p) {
    p.cracks = simulation.events();
    context.report(p);
  };
  RoughNetwork rough;
  if (is_rough) {
    rough = roughen(state.network, simulation.mesh(), roughness_options(state.recipe, surface),
                    counting);
    warn_of_roughness(report, state.recipe, rough);
  }
  if (on_itself) {
    surface.asset = std::move(surface.mesh);
    surface.asset_face.resize(surface.asset.triangles.size());
    std::iota(surface.asset_face.begin(), surface.asset_face.end(), 0);
  }
  const std::vector<Vec3> displacement = state.displacements();
  auto carried = std::make_unique<CrackedAsset>(
      carry_onto_asset(surface.asset,
                       {simulation.mesh(), state.network, displacement, state.fragments.face,
                        surface.asset_face, &surface.smooth, is_rough ? &rough : nullptr},
                       -1, counting));
  if (!state.network.edges.empty() && !on_itself) {
    const auto edges = static_cast<double>(state.network.edges.size());
    keep_to_planes(surface.asset, carried->cut, total_length(state.network) / edges,
                   carried->displacement);
  }
  state.network = std::move(carried->network);
  state.asset = std::move(carried);
  state.surface = std::move(surface.asset);
  state.fragments = find_components(state.mesh());
  report.carried = count_carried(state.asset->cut, state.surface.triangles.size());
  report.time.carry = seconds_since(start);
}

void warn_of_empty_mask(Report& report, const std::vector<double>& mask) {
  if (mask.empty()) return;
  if (std::any_of(mask.begin(), mask.end(), [](double m) { return m > 0; })) return;
  report.warnings.push_back("nothing can crack (where): it leaves no triangle of the surface");
}

}  // namespace

Result crack(Input input, const Recipe& recipe, const CrackOptions& options,
             const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  Report report;
  report.recipe = recipe;
  if (options.max_cracks) report.recipe.simulation.evolution.max_cracks = *options.max_cracks;
  report.threads = context.threads.count();
  check_recipe(recipe);
  const double unit = metres_per_unit(*input.surface, recipe);
  check_units(recipe, unit);
  warn_of_unused_unit(report, *input.surface);
  for (std::string& warning : check_where(*input.surface, recipe.simulation.where)) {
    report.warnings.push_back(std::move(warning));
  }
  report.input = count_mesh(*input.surface);
  context.report({"repair", 0, 0, report.input.triangles});
  TracedSurface traced = repaired(input, report, context);
  input.surface.reset();
  report.recipe =
      with_own_lengths(report.recipe, {bounding_diagonal(traced.surface.positions), unit});
  SimulationParameters& parameters = report.recipe.simulation;
  parameters.impacts = place_impacts(std::move(parameters.impacts), traced.surface, context);
  report.time.load = seconds_since(start);
  context.report({"prepare", -1, 0, count_mesh(traced.surface).triangles});
  context.check();

  SpacedRun run = options.max_cracks == 0
                      ? uncracked(std::move(traced.surface), report.recipe, input.textures, context)
                      : run_to_spacing(std::move(traced.surface), report.recipe, input.textures,
                                       context, options.on_opened);
  if (run.last.reason == StopReason::cancelled && options.on_cancel == OnCancel::discard) {
    throw Cancelled();
  }
  auto state = std::make_shared<CrackedSurface>();
  state->recipe = std::move(run.recipe);
  state->simulation = std::move(run.last.simulation);
  report.simulation = count_mesh(run.surface.mesh);
  warn_of_empty_mask(report, run.surface.mask);
  // What is to be kept is carried over whole.
  Context onward = context;
  if (options.on_cancel == OnCancel::keep) onward.cancelled = nullptr;
  settle(*state, std::move(run.surface), report, onward);
  resolve_gap(state->recipe.post, state->network);
  if (state->recipe.mesh.output == OutputMesh::asset) {
    state->surface_origin = std::move(traced.origin);
  }

  const Simulation& simulation = *state->simulation;
  report.recipe = state->recipe;
  report.output = {state->mesh().vertex_count(), state->mesh().face_count()};
  report.cracks = {simulation.events(), simulation.segments(), total_length(state->network),
                   state->fragments.count};
  report.stop_reason = to_string(run.last.reason);
  report.load = simulation.load();
  add_run_warnings(report, run.last, simulation);
  report.time.prepare = run.prepare + run.last.prepare;
  report.time.relax = run.last.times.relax;
  report.time.separation = run.last.times.separation;
  report.time.crack = run.last.times.crack;
  report.time.total = seconds_since(start);
  return {std::move(state), std::move(report)};
}

}  // namespace craze
