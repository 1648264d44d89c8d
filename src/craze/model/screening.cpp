#include "craze/model/screening.h"

#include <algorithm>
#include <cmath>

#include "craze/base/elementary.h"

namespace craze {

double spacing_per_screening_length(const SimulationParameters& p) {
  // Below this load hardly anything cracks and the formula runs to infinity.
  constexpr double least_load = 1.05;
  // Measured, on plates of a hundred cells.
  constexpr double cell_per_strip = 0.66, scatter_effect = 0.5, healing_effect = 0.6;
  const double load = std::max(p.evolution.most_load(), least_load);
  // 2 arcosh(1 / (1 − 1/load))
  const double strip = 2 * elementary::log((load + std::sqrt(2 * load - 1)) / (load - 1));
  const double scattered = 1 - scatter_effect * p.material.scatter;
  const double healed = p.evolution.cycles > 1 ? 1 + healing_effect * (1 - p.evolution.healing) : 1;
  return cell_per_strip * scattered * healed * strip;
}

SimulationParameters resolve_lengths(SimulationParameters p, double diagonal) {
  LayerParameters& layer = p.layer;
  if (layer.spacing == 0 && layer.screening_length == 0) {
    layer.spacing = layer.relative_spacing * diagonal;
  }
  if (layer.screening_length == 0) {
    layer.screening_length = layer.spacing / spacing_per_screening_length(p);
  }
  if (p.stress.noise_length == 0) {
    p.stress.noise_length = p.stress.relative_noise_length * layer.screening_length;
  }
  MaterialParameters& material = p.material;
  if (material.scatter_length == 0) {
    material.scatter_length = p.stress.noise_length;
    if (material.relative_scatter_length > 0) {
      material.scatter_length = material.relative_scatter_length * layer.screening_length;
    }
  }
  if (material.lookahead == 0) {
    material.lookahead = material.relative_lookahead * layer.screening_length;
  }
  if (material.criterion == Criterion::strength && material.relative_toughness > 0 &&
      layer.screening_length > 0) {
    material.toughness =
        material.relative_toughness * material.strength * std::sqrt(layer.screening_length);
  }
  return p;
}

double adhesion(const LayerParameters& layer) {
  return layer.screening_length > 0 ? 1 / (layer.screening_length * layer.screening_length) : 0;
}

double process_zone(const MaterialParameters& material, const LayerParameters& layer) {
  const double given = material.process_zone;
  return given > 0 ? given : 0.5 * layer.screening_length;
}

}  // namespace craze
