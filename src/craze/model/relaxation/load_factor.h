// All sources scaled by one factor, from event to event (engine = "quasistatic").
#pragma once

#include <algorithm>

#include "craze/model/relaxation/loading.h"

namespace craze {

/// The load factor s: between two cracks the field is s times the one stored and the load of the
/// next failure is known in closed form, so that no time is spent waiting.
class LoadFactor : public Loading {
 public:
  /// start: the load factor at which all places start; what counts from there is the stored
  /// field's factor.
  LoadFactor(const EvolutionParameters& parameters, double start);

  bool grow(StressField&, const TriangleMesh&) override { return false; }
  bool advance(double needed, bool at_rest) override;
  double load() const override { return load_; }
  double load_of_step() const override { return (1 + load_step_) * load_; }
  double highest_load() const override { return highest_; }
  double time() const override { return start_ + load_; }
  double reported_load() const override { return std::min(max_load_, start_ + load_); }
  bool reached_max_load() const override { return reached_max_load_; }

 private:
  double start_, max_load_, load_step_;
  double highest_;  // ≥ 0
  double load_ = 0;
  bool reached_max_load_ = false;
};

}  // namespace craze
