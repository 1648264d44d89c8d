#include "craze/io/polygons/float_grid.h"

#include <algorithm>
#include <cmath>

namespace craze {

double float_grid(const SurfaceMesh& mesh) {
  double most = 0;
  for (const Vec3& p : mesh.positions) most = std::max(most, p.cwiseAbs().maxCoeff());
  return float_grid(most);
}

double float_grid(double largest) {
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1, exponent - 23);
}

Vec3 on_grid(const Vec3& p, double grid) {
  return (p / grid).array().round().matrix() * grid;
}

Vec3 far_origin(const SurfaceMesh& mesh) {
  constexpr double noticed = 1e-6;  // of the mesh's size
  if (mesh.positions.empty()) return Vec3::Zero();
  Vec3 low = mesh.positions[0], high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).norm();
  if (!(float_grid(mesh) / 2 > noticed * size)) return Vec3::Zero();
  int exponent = 0;
  std::frexp(size, &exponent);
  return on_grid((low + high) / 2, std::ldexp(1, exponent));
}

Vec3 centroid(const SurfaceMesh& mesh) {
  Vec3 by_area = Vec3::Zero(), by_vertex = Vec3::Zero();
  double total = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const double area = (b - a).cross(c - a).norm();
    total += area;
    by_area += area * (a + b + c) / 3;
  }
  for (const Vec3& p : mesh.positions) by_vertex += p / static_cast<double>(mesh.positions.size());
  return total > 0 ? Vec3(by_area / total) : by_vertex;
}

}  // namespace craze
