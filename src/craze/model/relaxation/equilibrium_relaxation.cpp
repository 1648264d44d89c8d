#include "craze/model/relaxation/equilibrium_relaxation.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

#include "craze/model/failure/failure_criterion.h"
#include "craze/model/screening.h"

namespace craze {

namespace {

// Changes within this many screening lengths of each other are solved together.
constexpr double reach = 1.0;
// Failing nodes farther apart than this many screening lengths may crack in one step.
constexpr double independence = 4.0;

// Equilibrium is tightened everywhere each time the load has grown by this factor.
constexpr double accuracy_step = 1.25;

}  // namespace

EquilibriumRelaxation::EquilibriumRelaxation(const TriangleMesh& mesh,
                                             const SimulationParameters& parameters)
    : parameters_(parameters.evolution),
      failure_force_(typical_failure_force(mesh, parameters.material)),
      equilibrium_({adhesion(parameters.layer), 0, reach * parameters.layer.screening_length}),
      independence_(parameters.evolution.load_step > 0
                        ? independence * parameters.layer.screening_length
                        : std::numeric_limits<double>::infinity()),
      stride_(parameters.crack.stride * parameters.layer.screening_length) {
  assert(parameters.layer.screening_length > 0);
}

void EquilibriumRelaxation::mesh_changed(const TriangleMesh&, const CrackOutcome& outcome) {
  seeds_.insert(seeds_.end(), outcome.changed_nodes.begin(), outcome.changed_nodes.end());
}

void EquilibriumRelaxation::relax(StressField& field, const TriangleMesh& mesh, double load,
                                  const Threads& threads, const StopQuestion& stop,
                                  std::vector<std::int32_t>& changed) {
  // Forces are stored at load 1, where nodes fail at failure_force_ / load: as the load grows, what
  // was close enough to equilibrium has to be brought closer.
  if (load >= accurate_up_to_) {
    accurate_up_to_ = load > 0 ? accuracy_step * load : parameters_.max_load;
    const double failure_force = failure_force_ / accurate_up_to_;
    equilibrium_.set_tolerance(parameters_.residual * failure_force);
    seeds_.resize(mesh.vertex_count());
    std::iota(seeds_.begin(), seeds_.end(), 0);
  }
  std::sort(seeds_.begin(), seeds_.end());
  seeds_.erase(std::unique(seeds_.begin(), seeds_.end()), seeds_.end());
  bool stopped = false;
  const auto ask = [&] { return stopped = stopped || (stop && stop()); };
  equilibrium_.restore(field, mesh, seeds_, threads, changed, ask);
  seeds_.clear();
  if (stopped) accurate_up_to_ = 0;  // the next call takes in everything
}

}  // namespace craze
