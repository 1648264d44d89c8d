#include "craze/scenario/spacing_rounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "craze/mesh/components.h"
#include "craze/model/screening.h"

namespace craze {

namespace {

constexpr double close_enough = 0.05;
constexpr double worth_a_warning = 0.15;
constexpr double spread_of_one = 0.3;  // of a fragment's root area over the mean, about
constexpr double least_exponent = 0.4, largest_exponent = 1.2;
// Of the object's diagonal: with a longer ℓ no pattern changes any more.
constexpr double longest_screening = 2;

bool is_painted(const LayerParameters& layer) {
  return !layer.attribute.empty() || !layer.texture.empty();
}

/// A run whose lengths are resolved for this object, before anything is done.
SpacedRun resolved(const Recipe& recipe, double diagonal) {
  SpacedRun run;
  run.recipe = recipe;
  run.recipe.simulation = resolve_lengths(recipe.simulation, diagonal);
  return run;
}

void prepare(SpacedRun& run, SurfaceMesh repaired, const Context& context) {
  const auto begin = std::chrono::steady_clock::now();
  run.surface = simulation_surface(std::move(repaired), run.recipe, context);
  run.prepare += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void crack(SpacedRun& run, const Context& context) {
  LastCycle before = std::move(run.last);
  before.simulation.reset();
  run.last = run_cycles(run.surface, run.recipe.simulation, context);
  run.last.prepare += before.prepare;
  run.last.times.relax += before.times.relax;
  run.last.times.separation += before.times.separation;
  run.last.times.crack += before.times.crack;
}

}  // namespace

SpacedRun uncracked(SurfaceMesh repaired, const Recipe& recipe, const Context& context) {
  SpacedRun run = resolved(recipe, bounding_diagonal(repaired.positions));
  prepare(run, std::move(repaired), context);
  run.last = before_first_crack(run.surface, run.recipe.simulation, context);
  return run;
}

SpacedRun run_to_spacing(SurfaceMesh repaired, const Recipe& recipe, const Context& context) {
  const double diagonal = bounding_diagonal(repaired.positions);
  SpacedRun run = resolved(recipe, diagonal);
  const LayerParameters& layer = run.recipe.simulation.layer;
  const bool asked = layer.spacing > 0 && recipe.simulation.layer.screening_length == 0;
  const std::int64_t rounds = asked && !is_painted(layer) ? layer.rounds : 0;
  double exponent = 1, last_length = 0, last_ratio = 0;
  for (std::int64_t round = 0;; ++round) {
    prepare(run, round < rounds ? repaired : std::move(repaired), context);
    crack(run, context);
    if (round == rounds || run.last.reason == StopReason::cancelled ||
        run.last.reason == StopReason::max_cracks) {
      return run;
    }
    const TriangleMesh& mesh = run.last.simulation->mesh();
    const double ratio = mean_spacing(mesh, find_components(mesh).count) / layer.spacing;
    if (std::abs(ratio - 1) <= close_enough) return run;
    const double length = layer.screening_length;
    if (round > 0 && length != last_length) {
      exponent = std::clamp(std::log(ratio / last_ratio) / std::log(length / last_length),
                            least_exponent, largest_exponent);
    }
    last_length = length;
    last_ratio = ratio;
    SimulationParameters next = recipe.simulation;
    next.layer.spacing = layer.spacing;
    next.layer.screening_length =
        std::min(length * std::pow(ratio, -1 / exponent), longest_screening * diagonal);
    run.recipe.simulation = resolve_lengths(next, diagonal);
  }
}

double mean_spacing(const TriangleMesh& cut_mesh, std::int64_t fragments) {
  double area = 0;
  for (std::int32_t f = 0; f < cut_mesh.face_count(); ++f) area += cut_mesh.area(f);
  return std::sqrt(area / static_cast<double>(std::max<std::int64_t>(1, fragments)));
}

std::optional<std::string> spacing_warning(const LayerParameters& layer,
                                           const TriangleMesh& cut_mesh, std::int64_t fragments) {
  if (!(layer.spacing > 0) || is_painted(layer) || fragments == 0) return {};
  const double spacing = mean_spacing(cut_mesh, fragments), ratio = spacing / layer.spacing;
  const double chance = 2 * spread_of_one / std::sqrt(static_cast<double>(fragments));
  if (!(std::abs(ratio - 1) > worth_a_warning + chance)) return {};
  return fmt::format(
      "spacing {:.2f} of what was asked for (layer.spacing): {:.3g}, not {:.3g}; more layer.rounds "
      "bring it closer where the surface allows it",
      ratio, spacing, layer.spacing);
}

}  // namespace craze
