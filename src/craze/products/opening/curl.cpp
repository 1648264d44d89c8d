#include "craze/products/opening/curl.h"

#include "craze/products/opening/surface_extension.h"

namespace craze {

double natural_curl_length(const TriangleMesh& mesh, const CrackSites& sites) {
  double both_sides = 0;
  for (const std::int32_t h : sites.sides) {
    both_sides += (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
  }
  return both_sides > 0 ? 4 * mesh.total_area() / both_sides / 3 : 0;
}

std::vector<double> curl_lift(const TriangleMesh& mesh, const CrackSites& sites,
                              const std::vector<double>& edge_lift, double length) {
  std::vector<std::uint8_t> on_crack(mesh.vertex_count());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) on_crack[v] = sites.site_of[v] >= 0;
  return extend_over_surface(mesh, on_crack, edge_lift, length);
}

}  // namespace craze
