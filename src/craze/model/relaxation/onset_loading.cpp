#include "craze/model/relaxation/onset_loading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "craze/error.h"

namespace craze {

namespace {

// Of the load under which a typical place fails: bounds of a step, which otherwise is load_step.
constexpr double shortest_step = 0.005, longest_step = 0.05;
constexpr double most_steps = 1e5;
// Faces times steps: each of them is asked at each step whether it is on its way.
constexpr double most_node_steps = 2e10;

}  // namespace

bool is_staggered(const std::vector<double>& onset) {
  return std::adjacent_find(onset.begin(), onset.end(), std::not_equal_to<>()) != onset.end();
}

OnsetLoading::OnsetLoading(const EvolutionParameters& parameters, InitialLoad initial)
    : stress_(std::move(initial.stress)),
      onset_(std::move(initial.onset)),
      max_load_(parameters.max_load),
      most_load_(parameters.most_load()),
      step_(std::clamp(parameters.load_step, shortest_step, longest_step) * initial.failure_load) {
  std::copy_if(onset_.begin(), onset_.end(), std::back_inserter(starts_),
               [&](double o) { return o < max_load_; });
  std::sort(starts_.begin(), starts_.end());
  starts_.erase(std::unique(starts_.begin(), starts_.end()), starts_.end());
  last_ = starts_.empty() ? 0 : std::min(max_load_, starts_.back() + most_load_);
  const double steps = steps_in_all();
  if (steps <= most_steps && steps * static_cast<double>(onset_.size()) <= most_node_steps) return;
  std::ostringstream why;
  why << steps << " steps of load on " << onset_.size()
      << " triangles would take hours; give less, or less evolution.place_load";
  throw Error(ErrorKind::request, "too many steps", "evolution.max_load", why.str());
}

double OnsetLoading::steps_in_all() const {
  double way = 0;  // how far the load rises while places are on their way
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    const double next = i + 1 < starts_.size() ? starts_[i + 1] : last_;
    way += std::min(most_load_, next - starts_[i]);
  }
  return way / step_;
}

double OnsetLoading::own_load(double s, double onset) const {
  return std::clamp(s - onset, 0.0, most_load_);
}

double OnsetLoading::next_load() const {
  const auto later = std::upper_bound(starts_.begin(), starts_.end(), load_);
  const bool on_its_way = later != starts_.begin() && *(later - 1) + most_load_ > load_;
  const double from = on_its_way || later == starts_.end() ? load_ : *later;
  const double least = std::nextafter(from, std::numeric_limits<double>::infinity());
  return std::min(last_, std::max(from + step_, least));
}

bool OnsetLoading::advance(double needed, bool) {
  if (load_ < last_) {
    load_ = next_load();
    return true;
  }
  reached_max_load_ = starts_.empty() || (last_ == max_load_ && std::isfinite(needed));
  if (reached_max_load_) load_ = max_load_;
  return false;
}

void OnsetLoading::bring_up(StressField& field, const TriangleMesh& mesh,
                            const OnAddedForce& added) {
  if (borne_ == load_) return;
  nodes_.clear();
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const std::int32_t source = mesh.source_face(f);
    const double more = own_load(load_, onset_[source]) - own_load(borne_, onset_[source]);
    if (more == 0) continue;
    Element change = field.elements()[f];
    field.add_stress(mesh, f, more * stress_[source]);
    for (int k = 0; k < 3; ++k) change.t[k] = field.elements()[f].t[k] - change.t[k];
    double most = 0;
    for (int corner = 0; corner < 3; ++corner) {
      most = std::max(most, element_force(change, corner).norm());
    }
    for (const std::int32_t v : mesh.triangle(f)) {
      nodes_.push_back(v);
      added(v, most);
    }
  }
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  for (const std::int32_t v : nodes_) field.update_force(mesh, v);
  borne_ = load_;
}

}  // namespace craze
