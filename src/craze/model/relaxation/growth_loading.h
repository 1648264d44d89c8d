// [IO06] §3.1, step 3b.ii: tension that is added step by step (engine = "euler").
#pragma once

#include "craze/model/relaxation/loading.h"

namespace craze {

/// c I and the curvature tensor are added to every σ after each R steps of relaxation.
class GrowthLoading : public Loading {
 public:
  GrowthLoading(const EvolutionParameters& parameters, InitialLoad initial);

  bool grow(StressField& field, const TriangleMesh& mesh) override;
  bool advance(double needed, bool at_rest) override;
  double load() const override { return 1; }
  double highest_load() const override { return 1; }
  double time() const override { return time_; }
  double steps() const override;
  double reported_load() const override;
  bool reached_max_load() const override;

 private:
  bool grows() const { return rate_ > 0; }

  EvolutionParameters parameters_;
  InitialLoad initial_;
  double rate_;  // tension added per step
  double added_tension_ = 0;
  double time_ = 0;
  bool started_ = false;
};

}  // namespace craze
