// All sources scaled by one factor, from event to event (engine = "quasistatic").
#pragma once

#include "craze/model/relaxation/loading.h"

namespace craze {

/// The load factor s: between two cracks the field is s times the one stored and the load of the
/// next failure is known in closed form, so that no time is spent waiting.
class LoadFactor : public Loading {
 public:
  explicit LoadFactor(const EvolutionParameters& parameters) : parameters_(parameters) {}

  bool grow(StressField&, const TriangleMesh&) override { return false; }
  bool advance(double needed, bool at_rest) override;
  double load() const override { return load_; }
  double load_of_step() const override { return (1 + parameters_.load_step) * load_; }
  double highest_load() const override { return parameters_.max_load; }
  double time() const override { return load_; }
  double reported_load() const override { return load_; }
  bool reached_max_load() const override { return reached_max_load_; }

 private:
  EvolutionParameters parameters_;
  double load_ = 0;
  bool reached_max_load_ = false;
};

}  // namespace craze
