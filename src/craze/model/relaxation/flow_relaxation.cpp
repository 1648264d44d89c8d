#include "craze/model/relaxation/flow_relaxation.h"

#include <algorithm>
#include <limits>

#include "craze/model/failure/failure_criterion.h"
#include "craze/model/screening.h"

namespace craze {

namespace {

// A node is moved by a force above this part of that at which nodes fail: far below what any
// pattern sees, far above rounding.
constexpr double rest_force = 1e-7;
// Nothing more can happen once every force is below this part of it.
constexpr double equilibrium_force = 1e-3;
// Element updates, about an hour's: steps so short that it takes more move nothing that matters.
constexpr double most_work = 1e12;
}  // namespace

FlowRelaxation::FlowRelaxation(const TriangleMesh& mesh, const StressField& field,
                               const SimulationParameters& parameters)
    : parameters_(parameters.evolution),
      failure_force_(typical_failure_force(mesh, parameters.material)),
      flow_(mesh, field,
            {parameters.evolution.time_step, adhesion(parameters.layer),
             rest_force * failure_force_, parameters.engine == Engine::quasistatic}),
      faces_(mesh.face_count()),
      accelerated_(parameters.engine == Engine::quasistatic) {}

void FlowRelaxation::mesh_changed(const TriangleMesh&, const CrackOutcome& outcome) {
  changed_faces_.insert(changed_faces_.end(), outcome.changed_faces.begin(),
                        outcome.changed_faces.end());
  changed_nodes_.insert(changed_nodes_.end(), outcome.changed_nodes.begin(),
                        outcome.changed_nodes.end());
}

void FlowRelaxation::relax(StressField& field, const TriangleMesh& mesh, double,
                           const Threads& threads, const StopQuestion& stop,
                           std::vector<std::int32_t>& changed) {
  flow_.mesh_changed(mesh, field, changed_faces_, changed_nodes_);
  changed_faces_.clear();
  changed_nodes_.clear();
  if (flow_.has_steps_left()) {
    flow_.resume(field, mesh, threads, stop);
  } else {
    flow_.run(field, mesh, parameters_.relaxation_steps, threads, stop);
  }
  flow_.drifted(changed);
}

bool FlowRelaxation::at_rest() const {
  if (parameters_.relaxation_steps == 0) return true;
  if (work_of_a_round() * rounds_to_rest() > most_work) return true;
  return !(flow_.largest_force() > equilibrium_force * failure_force_);
}

double FlowRelaxation::work_of_a_round() const {
  const double faces = static_cast<double>(faces_);
  if (parameters_.relaxation_steps == 0 || accelerated_) return faces;  // many steps are few
  return static_cast<double>(parameters_.relaxation_steps) * flow_.parts_of_a_step() * faces;
}

double FlowRelaxation::rounds_to_rest() const {
  const double time = parameters_.time_step * static_cast<double>(parameters_.relaxation_steps);
  // Forces decay no faster than by exp(−λ t), λ the largest eigenvalue.
  return time > 0 && flow_.stiffness() > 0 ? std::max(1.0, 1 / (time * flow_.stiffness())) : 1;
}

double FlowRelaxation::independence_distance() const {
  return parameters_.cracks_per_step > 1 ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace craze
