#include "craze/model/screening.h"

namespace craze {

namespace {

// Mean spacing √Ā over ℓ at the end of a run with the default load.
constexpr double spacing_per_screening_length = 3;

}  // namespace

double screening_length(const LayerParameters& layer) {
  if (layer.spacing > 0) return layer.spacing / spacing_per_screening_length;
  return layer.screening_length;
}

double process_zone(const MaterialParameters& material, const LayerParameters& layer) {
  return material.process_zone > 0 ? material.process_zone : 0.5 * screening_length(layer);
}

double adhesion(const LayerParameters& layer) {
  const double length = screening_length(layer);
  return length > 0 ? 1 / (length * length) : 0;
}

}  // namespace craze
