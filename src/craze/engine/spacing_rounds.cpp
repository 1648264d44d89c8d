#include "craze/engine/spacing_rounds.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "craze/base/elementary.h"
#include "craze/base/text/format.h"
#include "craze/engine/initial_fields.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/mesh/components.h"
#include "craze/model/screening.h"
#include "craze/model/sources/crack_mask.h"

namespace craze {

namespace {

constexpr double close_enough = 0.05;
constexpr double worth_a_warning = 0.15;
constexpr double spread_of_one = 0.3;  // of a fragment's root area over the mean, about
constexpr double least_exponent = 0.4, largest_exponent = 1.2;
// Of the object's diagonal: with a longer ℓ no pattern changes any more. Of the ℓ first tried:
// where the spacing is so much too wide, a load too small to close the pattern is what keeps it so.
constexpr double longest_screening = 2, shortest_screening = 0.5;

bool is_painted(const LayerParameters& layer) {
  return !layer.attribute.empty() || !layer.texture.empty();
}

bool is_cut_short(StopReason reason) {
  return reason == StopReason::cancelled || reason == StopReason::max_cracks;
}

/// A run whose lengths are resolved for this object, before anything is done.
SpacedRun resolved(const Recipe& recipe, double diagonal) {
  SpacedRun run;
  run.recipe = recipe;
  run.recipe.simulation = resolve_lengths(recipe.simulation, diagonal);
  return run;
}

SimulationSurface masked_surface(SurfaceMesh repaired, const Recipe& recipe,
                                 const Textures& textures, const Context& context,
                                 const Period& period, double coarseness) {
  SimulationSurface surface =
      simulation_surface(std::move(repaired), recipe, context, period, coarseness);
  const WhereParameters& where = recipe.simulation.where;
  if (where.is_given()) {
    const SurfaceMesh& mesh = surface.mesh;
    surface.mask = crack_mask(mesh, TriangleMesh(mesh.positions, mesh.triangles, period), where,
                              find_texture(textures, where.texture, "where.texture"),
                              !surface.asset_face.empty());
  }
  context.check();
  return surface;
}

/// Makes what early cycles crack. Nothing where edges of one length are asked for, or where a cycle
/// may be the last because max_cracks is reached.
void prepare_early_cycles(SpacedRun& run, const SurfaceMesh& repaired, const Textures& textures,
                          const Context& context, const Period& period) {
  constexpr double least_edges = 16;  // along the diagonal, of a mesh that is worth making
  const auto begin = std::chrono::steady_clock::now();
  const SimulationParameters& parameters = run.recipe.simulation;
  if (parameters.evolution.max_cracks > 0) return;
  if (run.recipe.mesh.edge.kind != EdgeLength::Kind::automatic) return;
  const double diagonal = bounding_diagonal(repaired.positions, period);
  for (const double edges : coarser_edges(parameters.evolution.cycles)) {
    if (least_edges * edges * parameters.layer.screening_length > 4 * diagonal) break;
    run.coarser.push_back(masked_surface(repaired, run.recipe, textures, context, period, edges));
  }
  run.prepare += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void prepare(SpacedRun& run, SurfaceMesh repaired, const Textures& textures, const Context& context,
             const Period& period = {}) {
  const auto begin = std::chrono::steady_clock::now();
  run.surface = masked_surface(std::move(repaired), run.recipe, textures, context, period, 1);
  run.prepare += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// How many of the coarser meshes are worth changing to.
std::size_t count_worthwhile(const SpacedRun& run) {
  constexpr double fewer = 0.8;  // triangles
  auto triangles = static_cast<double>(run.surface.mesh.triangles.size());
  std::size_t count = 0;
  for (; count < run.coarser.size(); ++count) {
    const auto there = static_cast<double>(run.coarser[count].mesh.triangles.size());
    if (!(there < fewer * triangles)) break;
    triangles = there;
  }
  return count;
}

/// Cracks what was prepared.
void crack_prepared(SpacedRun& run, const Textures& textures, const Context& context,
                    const OnOpened& on_opened) {
  run.coarser.resize(count_worthwhile(run));
  run.last =
      run_cycles(run.surface, run.recipe.simulation, textures, context, on_opened, run.coarser);
  if (run.last.coarser > 0) run.surface = std::move(run.coarser[run.last.coarser - 1]);
  run.coarser.clear();
}

void add_times(SpacedRun& run, const SpacedRun& other) {
  run.prepare += other.prepare;
  run.last.prepare += other.last.prepare;
  run.last.times.relax += other.last.times.relax;
  run.last.times.separation += other.last.times.separation;
  run.last.times.crack += other.last.times.crack;
}

/// Looks for the ℓ at which the spacing over that asked for, a ratio, is 1: along the power law
/// through the two tries nearest on either side of it, else through the last two.
class LengthSearch {
 public:
  double next(double length, double ratio) {
    const Try now{length, ratio};
    if (ratio < 1 && (!below_ || length > below_->length)) below_ = now;
    if (ratio > 1 && (!above_ || length < above_->length)) above_ = now;
    if (below_ && above_ && below_->length < above_->length) {
      return below_->length * elementary::pow(below_->ratio, -1 / slope(*below_, *above_));
    }
    double exponent = 1;
    if (last_ && last_->length != length) {
      exponent = std::clamp(slope(*last_, now), least_exponent, largest_exponent);
    }
    last_ = now;
    return length * elementary::pow(ratio, -1 / exponent);
  }

 private:
  struct Try {
    double length, ratio;
  };

  static double slope(const Try& a, const Try& b) {
    return elementary::log(b.ratio / a.ratio) / elementary::log(b.length / a.length);
  }

  std::optional<Try> below_, above_, last_;
};

}  // namespace

SpacedRun uncracked(SurfaceMesh repaired, const Recipe& recipe, const Textures& textures,
                    const Context& context) {
  SpacedRun run = resolved(recipe, bounding_diagonal(repaired.positions));
  prepare(run, std::move(repaired), textures, context);
  run.last = before_first_crack(run.surface, run.recipe.simulation, textures, context);
  return run;
}

SpacedRun run_to_spacing(SurfaceMesh repaired, const Recipe& recipe, const Textures& textures,
                         const Context& context, const OnOpened& on_opened, const Period& period) {
  const double diagonal = bounding_diagonal(repaired.positions, period);
  SpacedRun run = resolved(recipe, diagonal);
  const double spacing = run.recipe.simulation.layer.spacing;
  const bool asked = spacing > 0 && recipe.simulation.layer.screening_length == 0 &&
                     !is_painted(recipe.simulation.layer);
  const std::int64_t rounds = asked ? recipe.simulation.layer.rounds : 0;
  if (rounds == 0) {
    prepare_early_cycles(run, repaired, textures, context, period);
    prepare(run, std::move(repaired), textures, context, period);
    crack_prepared(run, textures, context, on_opened);
    return run;
  }
  const double first_length = run.recipe.simulation.layer.screening_length;
  LengthSearch search;
  std::optional<SpacedRun> best;
  double best_error = std::numeric_limits<double>::infinity();
  for (std::int64_t round = 0;; ++round) {
    try {
      prepare_early_cycles(run, repaired, textures, context, period);
      prepare(run, repaired, textures, context, period);
      crack_prepared(run, textures, context, on_opened);
    } catch (const Cancelled&) {
      if (!best) throw;
      best->last.reason = StopReason::cancelled;
      return std::move(*best);
    }
    const StopReason reason = run.last.reason;
    const TriangleMesh& mesh = run.last.simulation->mesh();
    const double measured = run.surface.mask.empty()
                                ? mean_spacing(mesh, find_components(mesh).count)
                                : free_spacing(mesh, find_components(mesh), run.surface.mask);
    // No place that cracks freely says what the spacing is.
    if (round == 0 && (is_cut_short(reason) || measured == 0)) return run;
    const double ratio = measured / spacing;
    const double length = run.recipe.simulation.layer.screening_length;
    const double error = is_cut_short(reason) ? best_error : std::abs(elementary::log(ratio));
    if (error < best_error) {
      best_error = error;
      if (best) add_times(run, *best);
      best = std::move(run);
    } else {
      add_times(*best, run);
    }
    if (is_cut_short(reason)) best->last.reason = reason;
    if (round == rounds || is_cut_short(reason) || best_error <= close_enough) {
      return std::move(*best);
    }
    SimulationParameters next = recipe.simulation;
    next.layer.spacing = spacing;
    next.layer.screening_length =
        std::max(std::min(search.next(length, ratio), longest_screening * diagonal),
                 shortest_screening * first_length);
    run = {};
    run.recipe = recipe;
    run.recipe.simulation = resolve_lengths(next, diagonal);
  }
}

double mean_spacing(const TriangleMesh& cut_mesh, std::int64_t fragments) {
  double area = 0;
  for (std::int32_t f = 0; f < cut_mesh.face_count(); ++f) area += cut_mesh.area(f);
  return std::sqrt(area / static_cast<double>(std::max<std::int64_t>(1, fragments)));
}

double free_spacing(const TriangleMesh& cut_mesh, const Components& fragments,
                    const std::vector<double>& mask) {
  const auto parts = static_cast<std::size_t>(fragments.count);
  std::vector<double> area(parts, 0), free(parts, 0);
  for (std::int32_t f = 0; f < cut_mesh.face_count(); ++f) {
    const double of_face = cut_mesh.area(f);
    const std::int32_t part = fragments.face[f];
    area[part] += of_face;
    if (mask[cut_mesh.source_face(f)] == 1) free[part] += of_face;
  }
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < parts; ++i) {
    sum += free[i];
    if (area[i] > 0) count += free[i] / area[i];
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
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
