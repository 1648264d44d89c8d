#include "craze/engine.h"

#include <algorithm>
#include <chrono>

#include "craze/engine/check_where.h"
#include "craze/engine/cracked_surface.h"
#include "craze/engine/place_impacts.h"
#include "craze/engine/settle.h"
#include "craze/engine/spacing_rounds.h"
#include "craze/engine/welded_values.h"
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

/// What settling wants of a run that has ended, and of the report so far.
void grow_into(CrackedSurface& state, SpacedRun run, const Report& report,
               const Yardstick& yardstick) {
  if (!run.surface.numbering.empty()) {
    const Numbering back = inverse(run.surface.numbering);
    run.last.simulation->renumber(back);
    renumber(run.surface.mesh, back);
  }
  state.simulation = std::move(run.last.simulation);
  const bool on_itself = run.surface.asset.triangles.empty();
  state.surface = std::make_shared<const SurfaceMesh>(
      std::move(on_itself ? run.surface.mesh : run.surface.asset));
  if (on_itself) run.surface.asset_face.clear();
  state.run = std::make_shared<const GrownRun>(
      GrownRun{report, yardstick, std::move(run.last), std::move(run.surface.asset_face)});
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
  const std::shared_ptr<const SurfaceMesh> lost_values = lost_by_welding(*input.surface, traced);
  input.surface.reset();
  const Yardstick yardstick{bounding_diagonal(traced.surface.positions), unit};
  report.recipe = with_own_lengths(report.recipe, yardstick);
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
  report.recipe = std::move(run.recipe);
  report.simulation = count_mesh(run.surface.mesh);
  report.stop_reason = to_string(run.last.reason);
  report.load = run.last.simulation->load();
  report.time.prepare = run.prepare + run.last.prepare;
  report.time.relax = run.last.times.relax;
  report.time.separation = run.last.times.separation;
  report.time.crack = run.last.times.crack;
  // What is to be kept is carried over whole.
  Context onward = context;
  if (options.on_cancel == OnCancel::keep) onward.cancelled = nullptr;
  auto state = std::make_shared<CrackedSurface>();
  if (report.recipe.mesh.output == OutputMesh::asset) {
    state->surface_origin = std::make_shared<const RepairOrigin>(std::move(traced.origin));
  }
  state->lost_values = lost_values;
  const std::vector<Vec3> smooth = std::move(run.surface.smooth);
  grow_into(*state, std::move(run), report, yardstick);
  const Result settled = settle(state, state->run->report.recipe.post, smooth, onward);
  report = settled.report();
  report.time.total = seconds_since(start);
  return {std::move(state), std::move(report)};
}

}  // namespace craze
