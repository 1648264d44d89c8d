#include "craze/engine/cycles.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <vector>

#include "craze/base/random.h"
#include "craze/engine/initial_fields.h"
#include "craze/error.h"
#include "craze/model/crack_network.h"
#include "craze/model/junction_drift.h"
#include "craze/model/relaxation/onset_loading.h"

namespace craze {

namespace {

// The last so many cycles are cracked on the mesh itself, and the last so many on no mesh coarser
// than the first of the coarser ones.
constexpr std::int64_t fine_cycles = 3, finer_cycles = 8;
// Equilibrium on a coarser mesh need not be nearer than this.
constexpr double coarser_residual = 0.05;
// What a cycle takes on each mesh, over what it takes on the finest.
constexpr double work_on[] = {1, 0.3, 0.15};

/// Which mesh a cycle cracks, as LastCycle::coarser.
std::size_t coarseness_of(std::int64_t cycle, std::int64_t cycles, std::size_t meshes) {
  const std::int64_t left = cycles - cycle;
  const std::size_t wanted = left <= fine_cycles ? 0 : left <= finer_cycles ? 1 : 2;
  return std::min(wanted, meshes);
}

/// How much of a run lies before each of its cycles, and at last the whole: 0 … 1.
std::vector<double> work_before(std::int64_t cycles, std::size_t meshes) {
  std::vector<double> before(1, 0);
  for (std::int64_t cycle = 0; cycle < cycles; ++cycle) {
    before.push_back(before.back() + work_on[coarseness_of(cycle, cycles, meshes)]);
  }
  const double whole = before.back();
  for (double& work : before) work /= whole;
  return before;
}

SimulationParameters of_cycle(SimulationParameters parameters, std::int64_t cycle,
                              std::size_t coarser) {
  if (cycle > 0) parameters.seed = hash_bits(parameters.seed ^ hash_bits(cycle));
  if (coarser > 0) {
    double& residual = parameters.evolution.residual;
    residual = std::max(residual, coarser_residual);
  }
  return parameters;
}

/// The context of one cycle of several, which reports how far all of them are.
Context in_cycle(const Context& context, double fraction, std::int64_t cycles) {
  Context inner = context;
  if (cycles == 1 || !context.progress) return inner;
  inner.progress = [report = context.progress, fraction](Progress progress) {
    progress.fraction = fraction;
    report(progress);
  };
  return inner;
}

bool has_no_stress(const SimulationFields& fields, const SimulationParameters& parameters) {
  return parameters.evolution.shrinkage == 0 && fields.growth.empty() &&
         std::all_of(fields.stress.begin(), fields.stress.end(),
                     [](const Sym3& sigma) { return sigma.matrix().isZero(0); });
}

bool starts_too_late(const std::vector<double>& onset, double max_load) {
  return !onset.empty() &&
         std::all_of(onset.begin(), onset.end(), [&](double o) { return o >= max_load; });
}

bool leaves_nothing(const std::vector<double>& mask) {
  return !mask.empty() && std::none_of(mask.begin(), mask.end(), [](double m) { return m > 0; });
}

void start(LastCycle& last, const SimulationSurface& surface,
           const SimulationParameters& parameters, const Textures& textures, HealedCracks healed,
           const Context& context) {
  const auto begin = std::chrono::steady_clock::now();
  TriangleMesh mesh(surface.mesh.positions, surface.mesh.triangles, surface.period);
  SimulationFields fields = initial_fields(surface, mesh, parameters, textures, context);
  last.unstressed = has_no_stress(fields, parameters);
  last.closed = leaves_nothing(surface.mask);
  last.staggered = is_staggered(fields.onset);
  last.unloaded = starts_too_late(fields.onset, parameters.evolution.max_load);
  fields.healed = std::move(healed);
  // The cycle before makes room. Without it there is nothing to keep but this one, which is stopped
  // where its nodes are looked at, not here.
  Context onward = context;
  if (last.simulation) onward.cancelled = nullptr;
  last.simulation.reset();
  last.simulation =
      std::make_unique<Simulation>(std::move(mesh), std::move(fields), parameters, onward);
  last.prepare += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

std::span<const double> coarser_edges(std::int64_t cycles) {
  static constexpr double edges[] = {1.5, 2};
  return std::span(edges).first(coarseness_of(0, cycles, std::size(edges)));
}

double coarseness(const LastCycle& last, const SimulationParameters& parameters) {
  return last.coarser == 0 ? 1 : coarser_edges(parameters.evolution.cycles)[last.coarser - 1];
}

LastCycle before_first_crack(const SimulationSurface& surface,
                             const SimulationParameters& parameters, const Textures& textures,
                             const Context& context) {
  LastCycle first;
  start(first, surface, parameters, textures, {}, context);
  return first;
}

LastCycle run_cycles(const SimulationSurface& surface, const SimulationParameters& parameters,
                     const Textures& textures, const Context& context, const OnOpened& on_opened,
                     std::span<const SimulationSurface> coarser) {
  const EvolutionParameters& evolution = parameters.evolution;
  const double scar_width = evolution.scar_width * parameters.layer.screening_length;
  if (evolution.cycles > 1 && !(scar_width > 0)) {
    throw Error(ErrorKind::request, "cannot crack in cycles", "evolution.cycles",
                "a layer without adhesion does not heal: set layer.spacing or screening_length");
  }
  LastCycle last;
  HealedCracks healed;
  const std::vector<double> before = work_before(evolution.cycles, coarser.size());
  for (std::int64_t cycle = 0; cycle < evolution.cycles; ++cycle) {
    const Context inner = in_cycle(context, before[cycle], evolution.cycles);
    const std::size_t level = coarseness_of(cycle, evolution.cycles, coarser.size());
    try {
      start(last, level == 0 ? surface : coarser[level - 1], of_cycle(parameters, cycle, level),
            textures, std::move(healed), inner);
      last.coarser = level;
    } catch (const Cancelled&) {
      if (cycle == 0) throw;
      last.reason = StopReason::cancelled;  // the cracks of the cycle before stand
      break;
    }
    last.reason = last.simulation->run(inner, on_opened);
    const PhaseTimes& times = last.simulation->times();
    last.times.relax += times.relax;
    last.times.separation += times.separation;
    last.times.crack += times.crack;
    if (last.reason == StopReason::cancelled || last.reason == StopReason::max_cracks) break;
    healed = {};
    if (cycle + 1 < evolution.cycles && evolution.healing < 1) {
      CrackNetwork cracks = crack_network(*last.simulation);
      const double drift = evolution.drift * parameters.layer.screening_length;
      if (drift > 0) cracks = drifted(cracks, drift);
      healed = HealedCracks(healed_pieces(cracks), evolution.healing, scar_width, cracks.period);
    }
  }
  return last;
}

}  // namespace craze
