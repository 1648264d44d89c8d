// Places that come under load one after the other (engine = "quasistatic", evolution.onset_*).
#pragma once

#include "craze/model/relaxation/loading.h"

namespace craze {

/// Whether places start at different loads.
bool is_staggered(const std::vector<double>& onset);

/// A place with the onset o bears the load min(max(0, s − o), most_load()) of its own while the
/// load factor s grows, so that no factor on one stored field makes the field of the next load.
/// s rises in steps instead, and what is stored is the true field.
///
/// At every step the stress sources of every place are those of its own load at s, to rounding, and
/// equilibrium is restored; cracks open under them and are dated s. So no crack is early, and none
/// is later than by a step, which is a given part of the load under which a typical place fails. A
/// face is changed in no more steps than it takes to load it, wherever the front is: a front that
/// crosses N faces costs O(N) changes and not N at each of its steps. While no place is on its way
/// the load jumps to the next onset.
class OnsetLoading : public Loading {
 public:
  /// Wants an InitialLoad with stress, onset and failure_load. Throws Error(request) where the
  /// steps would take hours.
  OnsetLoading(const EvolutionParameters& parameters, InitialLoad initial);

  bool grow(StressField&, const TriangleMesh&) override { return false; }
  void bring_up(StressField& field, const TriangleMesh& mesh, const OnAddedForce& added) override;
  bool advance(double needed, bool at_rest) override;
  double load() const override { return 1; }
  double highest_load() const override { return 1; }
  double time() const override { return load_; }
  double reported_load() const override { return load_; }
  bool reached_max_load() const override { return reached_max_load_; }

  /// How much the load rises in a step.
  double step() const { return step_; }

 private:
  double next_load() const;
  /// The load of its own that a place with this onset bears at s.
  double own_load(double s, double onset) const;
  double steps_in_all() const;

  std::vector<Sym3> stress_;    // per source face, at the load 1 of its own
  std::vector<double> onset_;   // per source face
  std::vector<double> starts_;  // those below max_load, ascending, each once
  double max_load_, most_load_;
  double step_;
  double last_;                  // nothing changes beyond
  double load_ = 0, borne_ = 0;  // s; the s of the stored field
  bool reached_max_load_ = false;
  std::vector<std::int32_t> nodes_;  // whose forces have changed
};

}  // namespace craze
