// The flow u' = F between two cracks: engine = "euler", the paper's scheme to the letter, and
// "quasistatic" without adhesion, the same flow in fewer steps.
#pragma once

#include "craze/model/relaxation/euler_relaxation.h"
#include "craze/model/relaxation/relaxation.h"
#include "craze/threads.h"

namespace craze {

/// R Euler steps of relaxation.
class FlowRelaxation : public Relaxation {
 public:
  FlowRelaxation(const TriangleMesh& mesh, const StressField& field,
                 const SimulationParameters& parameters);

  void mesh_changed(const TriangleMesh& mesh, const CrackOutcome& outcome) override;
  void relax(StressField& field, const TriangleMesh& mesh, double load, const Threads& threads,
             const StopQuestion& stop, std::vector<std::int32_t>& changed) override;
  double allow_drift(std::int32_t v, double force) override { return flow_.allow_drift(v, force); }
  // Whoever adds to the forces here names all nodes himself (GrowthLoading).
  bool force_added(std::int32_t, double) override { return true; }
  double work_of_a_round() const override;
  bool at_rest() const override;
  double independence_distance() const override;
  std::int64_t most_cracks_at_once() const override { return parameters_.cracks_per_step; }
  std::int64_t element_updates() const override { return flow_.element_updates(); }

 private:
  double rounds_to_rest() const;

  EvolutionParameters parameters_;
  double failure_force_;
  EulerRelaxation flow_;
  std::int32_t faces_;  // of the mesh before its first crack
  bool accelerated_;
  std::vector<std::int32_t> changed_faces_, changed_nodes_;  // since relax()
};

}  // namespace craze
