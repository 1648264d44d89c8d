#include "craze/engine/settle.h"

#include <chrono>
#include <iterator>
#include <numeric>
#include <utility>

#include "craze/engine/asset/keep_to_planes.h"
#include "craze/engine/run_outcome.h"
#include "craze/engine/simulation_surface.h"
#include "craze/error.h"
#include "craze/recipe/check_recipe.h"

namespace craze {

namespace {

CarriedCounts count_carried(const CutAsset& cut, std::size_t triangles_before) {
  CarriedCounts counts;
  counts.split_triangles = cut.report.split_faces;
  counts.added_triangles = std::ssize(cut.triangles) - static_cast<std::int64_t>(triangles_before);
  counts.rerouted_pieces = cut.report.traced.rerouted;
  counts.lost_pieces = cut.report.traced.lost + cut.report.lost_segments;
  counts.lost_length = cut.report.traced.lost_length;
  return counts;
}

/// Puts the cracks of a finished run, whose network and fragments are those of its simulation, into
/// the surface.
void carry(CrackedSurface& state, const std::vector<Vec3>& smooth, Report& report,
           const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  const Simulation& simulation = *state.simulation;
  const SurfaceMesh& surface = *state.surface;
  const bool is_rough = report.recipe.post.roughness > 0;
  const bool on_itself = state.run->asset_face.empty();
  if (on_itself && !is_rough) return;
  Context counting = context;
  counting.progress = [&](Progress p) {
    p.cracks = simulation.events();
    context.report(p);
  };
  RoughNetwork rough;
  if (is_rough) {
    rough = roughen(state.network, simulation.mesh(), roughness_options(report.recipe, simulation),
                    counting);
    warn_of_roughness(report, report.recipe, rough);
  }
  std::vector<std::int32_t> own_faces;
  if (on_itself) {
    own_faces.resize(surface.triangles.size());
    std::iota(own_faces.begin(), own_faces.end(), 0);
  }
  const std::vector<Vec3> displacement = state.displacements();
  auto carried = std::make_unique<CrackedAsset>(carry_onto_asset(
      surface,
      {simulation.mesh(), state.network, displacement, state.fragments.face,
       on_itself ? own_faces : state.run->asset_face, &smooth, is_rough ? &rough : nullptr},
      -1, counting));
  if (!state.network.edges.empty() && !on_itself) {
    const auto edges = static_cast<double>(state.network.edges.size());
    keep_to_planes(surface, carried->cut, total_length(state.network) / edges,
                   carried->displacement);
  }
  state.network = std::move(carried->network);
  report.carried = count_carried(carried->cut, surface.triangles.size());
  carried->cut.positions = std::vector<Vec3>();
  carried->cut.triangles = std::vector<Triangle>();
  state.asset = std::move(carried);
  state.fragments = find_components(state.mesh());
  report.time.carry =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Whether cracks come out the same by both, whose relative_roughness is resolved.
bool same_lines(const PostParameters& a, const PostParameters& b) {
  if (a.roughness != b.roughness) return false;
  return a.roughness == 0 ||
         (a.roughness_exponent == b.roughness_exponent && a.roughness_step == b.roughness_step);
}

}  // namespace

Result settle(std::shared_ptr<CrackedSurface> grown, const PostParameters& post,
              const std::vector<Vec3>& smooth, const Context& context) {
  const GrownRun& run = *grown->run;
  Report report = run.report;
  report.recipe.post = post;
  const Simulation& simulation = *grown->simulation;
  grown->asset = nullptr;
  grown->network = crack_network(simulation);
  grown->fragments = find_components(simulation.mesh());
  resolve_roughness(report.recipe.post, grown->network);
  carry(*grown, smooth, report, context);
  resolve_gap(report.recipe.post, grown->network);
  report.output = {grown->mesh().vertex_count(), grown->mesh().face_count()};
  report.cracks = {simulation.events(), simulation.segments(), total_length(grown->network),
                   grown->fragments.count};
  add_run_warnings(report, run.last, simulation);
  return {std::move(grown), std::move(report)};
}

PostParameters asked_post(const Result& result) {
  return result.state().run->report.recipe.post;
}

Result with_post(const Result& result, const PostParameters& post, const Context& context,
                 const Result* other) {
  const CrackedSurface& state = result.state();
  const GrownRun& run = *state.run;
  Recipe recipe = run.report.recipe;
  recipe.post = post;
  check_recipe(recipe);
  recipe = with_own_lengths(recipe, run.yardstick);
  PostParameters resolved = recipe.post;
  resolve_roughness(resolved, crack_network(*state.simulation));
  for (const Result* same : {&result, other}) {
    if (!same || same->state().run != state.run) continue;
    if (!same_lines(same->report().recipe.post, resolved)) continue;
    Report report = same->report();
    report.recipe.post = resolved;
    resolve_gap(report.recipe.post, same->state().network);
    return {same->shared_state(), std::move(report)};
  }
  const auto start = std::chrono::steady_clock::now();
  std::vector<Vec3> smooth;
  if (!run.asset_face.empty()) {
    smooth = smooth_asset(*state.surface, recipe, coarseness(run.last, recipe.simulation));
  }
  auto again = std::make_shared<CrackedSurface>();
  again->surface = state.surface;
  again->surface_origin = state.surface_origin;
  again->lost_values = state.lost_values;
  again->simulation = state.simulation;
  again->run = state.run;
  Report report = settle(again, recipe.post, smooth, context).report();
  report.time.total =
      result.report().time.total +
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {std::move(again), std::move(report)};
}

}  // namespace craze
