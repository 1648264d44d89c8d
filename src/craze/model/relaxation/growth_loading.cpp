#include "craze/model/relaxation/growth_loading.h"

#include <algorithm>

namespace craze {

GrowthLoading::GrowthLoading(const EvolutionParameters& parameters, InitialLoad initial)
    : parameters_(parameters), initial_(std::move(initial)), rate_(parameters.shrinkage) {
  if (rate_ == 0) rate_ = initial_.growth_tension;
}

bool GrowthLoading::grow(StressField& field, const TriangleMesh& mesh) {
  started_ = true;
  time_ += parameters_.time_step * static_cast<double>(parameters_.relaxation_steps);
  if (!grows()) return false;
  const double c = parameters_.shrinkage;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    Sym3 growth;
    if (!initial_.growth.empty()) growth = initial_.growth[mesh.source_face(f)];
    growth += Sym3{c, c, c, 0, 0, 0};
    field.add_stress(mesh, f, growth);
  }
  field.update_forces(mesh);
  added_tension_ += rate_;
  return true;
}

bool GrowthLoading::advance(double, bool at_rest) {
  if (grows()) return !reached_max_load();
  return !started_ || !at_rest;
}

double GrowthLoading::steps() const {
  if (!grows()) return 1;
  const double to_add =
      initial_.tension > 0 ? (parameters_.max_load - 1) * initial_.tension : parameters_.max_load;
  return std::max(1.0, to_add / rate_);
}

double GrowthLoading::reported_load() const {
  return initial_.tension > 0 ? 1 + added_tension_ / initial_.tension : added_tension_;
}

bool GrowthLoading::reached_max_load() const {
  return grows() && reported_load() >= parameters_.max_load;
}

}  // namespace craze
