// engine = "quasistatic": equilibrium at every crack.
#pragma once

#include "craze/model/relaxation/equilibrium.h"
#include "craze/model/relaxation/relaxation.h"
#include "craze/threads.h"

namespace craze {

/// After a crack, equilibrium is restored around it (equilibrium.h).
class EquilibriumRelaxation : public Relaxation {
 public:
  /// The layer must have adhesion.
  EquilibriumRelaxation(const TriangleMesh& mesh, const SimulationParameters& parameters);

  void mesh_changed(const TriangleMesh& mesh, const CrackOutcome& outcome) override;
  void relax(StressField& field, const TriangleMesh& mesh, double load, const Threads& threads,
             const StopQuestion& stop, std::vector<std::int32_t>& changed) override;
  double allow_drift(std::int32_t v, double force) override {
    return equilibrium_.allow_drift(v, force);
  }
  bool force_added(std::int32_t v, double force) override {
    return equilibrium_.force_added(v, force);
  }
  void release_memory() override { equilibrium_.release_memory(); }
  bool at_rest() const override { return true; }
  bool met_tolerance() const override { return equilibrium_.met_tolerance(); }
  double independence_distance() const override { return independence_; }
  std::int64_t most_cracks_at_once() const override { return 64; }
  double stride() const override { return stride_; }
  std::int64_t element_updates() const override { return equilibrium_.element_updates(); }

 private:
  EvolutionParameters parameters_;
  double failure_force_;
  Equilibrium equilibrium_;
  double independence_, stride_;
  std::vector<std::int32_t> seeds_;
  double accurate_up_to_ = 0;
};

}  // namespace craze
