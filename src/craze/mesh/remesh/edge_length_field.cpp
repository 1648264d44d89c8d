#include "craze/mesh/remesh/edge_length_field.h"

#include <algorithm>
#include <cmath>

namespace craze {

std::vector<double> edge_length_field(const TriangleMesh& mesh, double target, bool coarsen) {
  std::vector<double> length(mesh.vertex_count(), target);
  if (coarsen || mesh.face_count() == 0) return length;
  const double mean_area = mesh.total_area() / mesh.face_count();
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    double area = 0;
    int faces = 0;
    mesh.for_each_outgoing(v, [&](std::int32_t h) {
      area += mesh.area(h / 3);
      ++faces;
    });
    if (faces > 0)
      length[v] = std::sqrt(4 / std::sqrt(3.0) * std::max(area / faces, mean_area / 64));
  }
  const int smoothings = 3;
  for (int i = 0; i < smoothings; ++i) {
    std::vector<double> mean(length.size());
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      double sum = length[v], count = 1;
      mesh.for_each_outgoing(v, [&](std::int32_t h) {
        sum += length[mesh.to(h)];
        count += 1;
      });
      mean[v] = sum / count;
    }
    length = std::move(mean);
  }
  for (double& l : length) l = std::min(l, target);
  return length;
}

}  // namespace craze
