#include "craze/model/relaxation/euler_evolution.h"

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

}  // namespace

EulerEvolution::EulerEvolution(const TriangleMesh& mesh, const StressField& field,
                               const SimulationParameters& parameters,
                               const EvolutionInputs& inputs)
    : parameters_(parameters.evolution),
      failure_force_(typical_failure_force(mesh, parameters.material)),
      initial_tension_(inputs.initial_tension),
      growth_(inputs.growth),
      relaxation_(mesh, field,
                  {parameters.evolution.time_step, adhesion(parameters.layer),
                   rest_force * failure_force_, parameters.engine == Engine::quasistatic}) {
  relaxation_.fixed = inputs.fixed;
}

void EulerEvolution::mesh_changed(const TriangleMesh&, const CrackOutcome& outcome) {
  changed_faces_.insert(changed_faces_.end(), outcome.changed_faces.begin(),
                        outcome.changed_faces.end());
  changed_nodes_.insert(changed_nodes_.end(), outcome.changed_nodes.begin(),
                        outcome.changed_nodes.end());
}

void EulerEvolution::evolve(StressField& field, const TriangleMesh& mesh, int threads,
                            std::vector<std::int32_t>& changed) {
  relaxation_.mesh_changed(mesh, field, changed_faces_, changed_nodes_);
  changed_faces_.clear();
  changed_nodes_.clear();
  relaxation_.run(field, mesh, parameters_.relaxation_steps, threads);
  time_ += parameters_.time_step * static_cast<double>(parameters_.relaxation_steps);
  if (grows()) {
    add_growth(field, mesh);
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) changed.push_back(v);
  } else {
    relaxation_.drifted(changed);
  }
}

void EulerEvolution::add_growth(StressField& field, const TriangleMesh& mesh) {
  const double c = parameters_.shrinkage;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    Sym3 growth;
    if (!growth_->empty()) growth = (*growth_)[mesh.source_face(f)];
    growth += Sym3{c, c, c, 0, 0, 0};
    field.add_stress(mesh, f, growth);
  }
  field.update_forces(mesh);
  added_tension_ += c;
}

bool EulerEvolution::advance(double) {
  if (grows()) return !reached_max_load();
  return time_ == 0 || relaxation_.largest_force() > equilibrium_force * failure_force_;
}

double EulerEvolution::independence_distance() const {
  return parameters_.cracks_per_step > 1 ? 0 : std::numeric_limits<double>::infinity();
}

double EulerEvolution::reported_load() const {
  return initial_tension_ > 0 ? 1 + added_tension_ / initial_tension_ : added_tension_;
}

bool EulerEvolution::reached_max_load() const {
  return parameters_.shrinkage > 0 && reported_load() >= parameters_.max_load;
}

}  // namespace craze
