#include "craze/model/screening.h"

#include <algorithm>
#include <cmath>

namespace craze {

double bounding_diagonal(const std::vector<Vec3>& positions) {
  if (positions.empty()) return 0;
  Vec3 low = positions.front(), high = low;
  for (const Vec3& p : positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

double spacing_per_screening_length(double s) {
  // Below this load hardly anything cracks and the formula runs to infinity.
  constexpr double least_load = 1.05;
  constexpr double cell_per_strip = 0.66;
  const double load = std::max(s, least_load);
  return cell_per_strip * 2 * std::acosh(1 / (1 - 1 / load));
}

SimulationParameters resolve_lengths(SimulationParameters p, double diagonal) {
  LayerParameters& layer = p.layer;
  if (layer.spacing == 0 && layer.screening_length == 0) {
    layer.spacing = layer.relative_spacing * diagonal;
  }
  if (layer.screening_length == 0) {
    layer.screening_length = layer.spacing / spacing_per_screening_length(p.evolution.max_load);
  }
  if (p.stress.noise_length == 0) {
    p.stress.noise_length = p.stress.relative_noise_length * layer.screening_length;
  }
  MaterialParameters& material = p.material;
  if (material.criterion == Criterion::strength && material.relative_toughness > 0) {
    material.toughness =
        material.relative_toughness * material.strength * std::sqrt(layer.screening_length);
  }
  return p;
}

double adhesion(const LayerParameters& layer) {
  return layer.screening_length > 0 ? 1 / (layer.screening_length * layer.screening_length) : 0;
}

double process_zone(const MaterialParameters& material, const LayerParameters& layer) {
  return material.process_zone > 0 ? material.process_zone : 0.5 * layer.screening_length;
}

}  // namespace craze
