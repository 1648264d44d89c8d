#include "craze/mesh/mesh_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace craze {

namespace {

std::int32_t count_components(const TriangleMesh& mesh) {
  std::vector<char> seen(mesh.face_count(), 0);
  std::vector<std::int32_t> stack;
  std::int32_t count = 0;
  for (std::int32_t start = 0; start < mesh.face_count(); ++start) {
    if (seen[start]) continue;
    ++count;
    seen[start] = 1;
    stack.push_back(start);
    while (!stack.empty()) {
      const std::int32_t f = stack.back();
      stack.pop_back();
      for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::int32_t o = mesh.opposite(h);
        if (o < 0 || seen[o / 3]) continue;
        seen[o / 3] = 1;
        stack.push_back(o / 3);
      }
    }
  }
  return count;
}

// A loop runs on from the end of an open halfedge with the first of that vertex's fan.
std::int32_t count_loops(const TriangleMesh& mesh) {
  std::vector<char> seen(3 * mesh.face_count(), 0);
  std::int32_t count = 0;
  for (std::int32_t start = 0; start < 3 * mesh.face_count(); ++start) {
    if (seen[start] || !mesh.is_open(start)) continue;
    ++count;
    for (std::int32_t h = start; !seen[h]; h = mesh.first_halfedge(mesh.to(h))) seen[h] = 1;
  }
  return count;
}

}  // namespace

double aspect_ratio(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  const double twice_area = (b - a).cross(c - a).norm();
  return twice_area > 0 ? longest * longest / twice_area : std::numeric_limits<double>::infinity();
}

MeshSummary summarize(const TriangleMesh& mesh) {
  MeshSummary s;
  s.faces = mesh.face_count();
  if (s.faces == 0) return s;
  const double infinity = std::numeric_limits<double>::infinity();
  Vec3 low = Vec3::Constant(infinity), high = Vec3::Constant(-infinity);
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.first_halfedge(v) < 0) continue;
    ++s.vertices;
    low = low.cwiseMin(mesh.position(v));
    high = high.cwiseMax(mesh.position(v));
  }
  s.diagonal = (high - low).norm();
  s.components = count_components(mesh);
  s.boundary_loops = count_loops(mesh);

  s.edge_min = infinity;
  std::int64_t edges = 0;
  double lengths = 0, volume = 0;
  const Vec3 origin = 0.5 * (low + high);  // near the surface: far from it the sum would cancel
  for (std::int32_t f = 0; f < s.faces; ++f) {
    const Triangle& t = mesh.triangle(f);
    const Vec3 &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
    s.area += mesh.area(f);
    volume += (a - origin).dot((b - origin).cross(c - origin)) / 6;
    s.worst_aspect = std::max(s.worst_aspect, aspect_ratio(a, b, c));
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh.opposite(h) > h) continue;  // each edge once: by its later or only side
      const double l = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
      ++edges;
      lengths += l;
      s.edge_min = std::min(s.edge_min, l);
      s.edge_max = std::max(s.edge_max, l);
    }
  }
  s.edge_mean = lengths / static_cast<double>(edges);
  s.euler_characteristic = static_cast<std::int32_t>(s.vertices - edges + s.faces);
  if (s.boundary_loops == 0) {
    s.genus = (2 * s.components - s.euler_characteristic) / 2;
    s.volume = volume;
  }
  return s;
}

}  // namespace craze
