#include "craze/mesh/shapes/periodic_square.h"

#include <cassert>

namespace craze {

SurfaceMesh periodic_square(double period, int cells) {
  assert(period > 0 && cells >= 4);
  SurfaceMesh square;
  const auto vertex = [cells](int i, int j) { return (j % cells) * cells + i % cells; };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      square.positions.emplace_back(period * i / cells, period * j / cells, 0);
      const std::int32_t corners[4] = {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1),
                                       vertex(i, j + 1)};
      const int start = (i + j) % 2;  // diagonals take turns
      for (const int second : {1, 2}) {
        square.triangles.push_back(
            {corners[start], corners[(start + second) % 4], corners[(start + second + 1) % 4]});
      }
    }
  }
  return square;
}

}  // namespace craze
