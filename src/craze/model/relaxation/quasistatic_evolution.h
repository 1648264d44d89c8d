// engine = "quasistatic": equilibrium at every crack, load from event to event.
#pragma once

#include "craze/model/relaxation/equilibrium.h"
#include "craze/model/relaxation/evolution.h"

namespace craze {

/// All sources are scaled by one load factor s, so between two cracks the field is s times the one
/// stored and the load of the next failure is known in closed form: no time is spent waiting.
/// After a crack, equilibrium is restored around it (equilibrium.h).
class QuasistaticEvolution : public Evolution {
 public:
  /// The layer must have adhesion.
  QuasistaticEvolution(const TriangleMesh& mesh, const SimulationParameters& parameters,
                       const EvolutionInputs& inputs);

  std::vector<char>& fixed() override { return equilibrium_.fixed; }
  void mesh_changed(const TriangleMesh& mesh, const CrackOutcome& outcome) override;
  void evolve(StressField& field, const TriangleMesh& mesh, int threads,
              std::vector<std::int32_t>& changed) override;
  double allow_drift(std::int32_t v, double force) override {
    return equilibrium_.allow_drift(v, force);
  }
  bool advance(double needed) override;
  void release_memory() override { equilibrium_.release_memory(); }
  double load() const override { return load_; }
  double load_of_step() const override { return (1 + parameters_.load_step) * load_; }
  double highest_load() const override { return parameters_.max_load; }
  double time() const override { return load_; }
  double independence_distance() const override { return independence_; }
  double stride() const override { return stride_; }
  std::int64_t element_updates() const override { return equilibrium_.element_updates(); }
  double reported_load() const override { return load_; }
  bool reached_max_load() const override { return reached_max_load_; }
  bool met_tolerance() const override { return equilibrium_.met_tolerance(); }

 private:
  EvolutionParameters parameters_;
  double failure_force_;
  Equilibrium equilibrium_;
  double independence_, stride_;
  std::vector<std::int32_t> seeds_;
  double load_ = 0;
  double accurate_up_to_ = 0;
  bool reached_max_load_ = false;
};

}  // namespace craze
