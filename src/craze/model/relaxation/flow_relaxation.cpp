#include "craze/model/relaxation/flow_relaxation.h"

#include <limits>
#include <sstream>
#include <string>

#include "craze/error.h"
#include "craze/model/failure/failure_criterion.h"
#include "craze/model/screening.h"

namespace craze {

namespace {

// A node is moved by a force above this part of that at which nodes fail: far below what any
// pattern sees, far above rounding.
constexpr double rest_force = 1e-7;
// Nothing more can happen once every force is below this part of it.
constexpr double equilibrium_force = 1e-3;
// Element updates between two cracks: about an hour.
constexpr double most_work = 1e12;

std::string number(double x) {
  std::ostringstream text;
  text << x;
  return text.str();
}

}  // namespace

FlowRelaxation::FlowRelaxation(const TriangleMesh& mesh, const StressField& field,
                               const SimulationParameters& parameters)
    : parameters_(parameters.evolution),
      failure_force_(typical_failure_force(mesh, parameters.material)),
      flow_(mesh, field,
            {parameters.evolution.time_step, adhesion(parameters.layer),
             rest_force * failure_force_, parameters.engine == Engine::quasistatic}) {
  // Accelerated, many steps are few.
  if (parameters.engine == Engine::quasistatic || work(mesh.face_count()) <= most_work) return;
  throw Error(ErrorKind::request, "too many relaxation steps",
              flow_.parts_of_a_step() > 1 ? "evolution.time_step" : "evolution.relaxation_steps",
              number(static_cast<double>(parameters_.relaxation_steps)) + " of them, each in " +
                  number(flow_.parts_of_a_step()) + " stable ones, on " +
                  std::to_string(mesh.face_count()) +
                  " triangles take hours between two cracks; give fewer, or a smaller time step");
}

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
  return !(flow_.largest_force() > equilibrium_force * failure_force_);
}

double FlowRelaxation::work(std::int32_t faces) const {
  return static_cast<double>(parameters_.relaxation_steps) * flow_.parts_of_a_step() * faces;
}

double FlowRelaxation::independence_distance() const {
  return parameters_.cracks_per_step > 1 ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace craze
