// The flow u' = F between two cracks: engine = "euler", the paper's scheme to the letter, and
// "quasistatic" without adhesion, the same flow in fewer steps.
#pragma once

#include "craze/model/relaxation/euler_relaxation.h"
#include "craze/model/relaxation/evolution.h"

namespace craze {

/// 3b.i R Euler steps of relaxation; 3b.ii c I and the curvature tensor are added to every σ.
class EulerEvolution : public Evolution {
 public:
  EulerEvolution(const TriangleMesh& mesh, const StressField& field,
                 const SimulationParameters& parameters, const EvolutionInputs& inputs);

  std::vector<char>& fixed() override { return relaxation_.fixed; }
  void mesh_changed(const TriangleMesh& mesh, const CrackOutcome& outcome) override;
  void evolve(StressField& field, const TriangleMesh& mesh, int threads,
              std::vector<std::int32_t>& changed) override;
  double allow_drift(std::int32_t v, double force) override {
    return relaxation_.allow_drift(v, force);
  }
  bool advance(double needed) override;
  double load() const override { return 1; }
  double highest_load() const override { return 1; }
  double time() const override { return time_; }
  double independence_distance() const override;
  std::int64_t element_updates() const override { return relaxation_.element_updates(); }
  double reported_load() const override;
  bool reached_max_load() const override;

 private:
  bool grows() const { return parameters_.shrinkage > 0 || !growth_->empty(); }
  void add_growth(StressField& field, const TriangleMesh& mesh);

  EvolutionParameters parameters_;
  double failure_force_;
  double initial_tension_, added_tension_ = 0;
  const std::vector<Sym3>* growth_;
  EulerRelaxation relaxation_;
  std::vector<std::int32_t> changed_faces_, changed_nodes_;  // since evolve()
  double time_ = 0;
};

}  // namespace craze
