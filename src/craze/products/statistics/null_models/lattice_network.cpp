#include <cmath>

#include "craze/products/statistics/graph/clipped_network.h"
#include "craze/products/statistics/null_models/null_networks.h"

namespace craze {

CrackNetwork lattice_network(Lattice lattice, double side) {
  // All three are a brick wall of points (i, j), joined along each row and, from every point or
  // from every other one, to the next row. Honeycombs have their rows in zigzag.
  Vec2 step(1, 1);
  double zigzag = 0;
  if (lattice == Lattice::hexagonal) {
    const double a = std::sqrt(2 / (3 * std::sqrt(3.0)));
    step = {std::sqrt(3.0) / 2 * a, 1.5 * a};
    zigzag = a / 4;
  } else if (lattice == Lattice::brick) {
    step = Vec2::Constant(std::sqrt(0.5));
  }
  const Vec2 shift(0.5, 0.5);  // keeps the lines off the window's sides
  const auto is_odd = [](std::int32_t i, std::int32_t j) { return ((i + j) & 1) != 0; };
  const auto point = [&](std::int32_t i, std::int32_t j) -> Vec2 {
    return shift + Vec2(i * step.x(), j * step.y() + (is_odd(i, j) ? zigzag : -zigzag));
  };
  ClippedNetwork network(side);
  const auto columns = static_cast<std::int32_t>(side / step.x()) + 2;
  const auto rows = static_cast<std::int32_t>(side / step.y()) + 2;
  for (std::int32_t j = -2; j <= rows; ++j) {
    for (std::int32_t i = -2; i <= columns; ++i) {
      network.add({i, j, 0}, point(i, j), {i + 1, j, 0}, point(i + 1, j));
      if (lattice != Lattice::square && !is_odd(i, j)) continue;
      network.add({i, j, 0}, point(i, j), {i, j + 1, 0}, point(i, j + 1));
    }
  }
  return network.take();
}

}  // namespace craze
