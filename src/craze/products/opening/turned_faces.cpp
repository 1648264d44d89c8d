#include "craze/products/opening/turned_faces.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace craze {

namespace {

constexpr int joining_rounds = 10;     // in each, faces beside those that move as one may join them
constexpr int faces_per_turned = 20;   // more turn: it is not about needles
constexpr double one_surface = 0.906;  // cosine of 25 degrees

Vec3 area_normal(const std::vector<Vec3>& p, const Triangle& t) {
  return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
}

/// 0 on a surface, 1 on a hard edge, 2 at a corner: how many directions a vertex may not go.
int hardness(const TriangleMesh& mesh, std::int32_t v) {
  std::vector<Vec3> normals;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const Vec3 n = area_normal(mesh.positions(), mesh.triangle(h / 3)).stableNormalized();
    if (n.isZero(0)) return;
    for (const Vec3& m : normals) {
      if (m.dot(n) > one_surface) return;
    }
    normals.push_back(n);
  });
  return std::clamp(static_cast<int>(normals.size()) - 1, 0, 2);
}

/// The mean shift of those that may go least.
Vec3 mean_of_hardest(const TriangleMesh& mesh, const std::vector<Vec3>& shift,
                     const std::vector<std::int32_t>& group) {
  std::array<Vec3, 3> sum{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  std::array<int, 3> count{};
  for (const std::int32_t v : group) {
    const auto k = static_cast<std::size_t>(hardness(mesh, v));
    sum[k] += shift[v];
    ++count[k];
  }
  const std::size_t k = count[2] > 0 ? 2 : count[1] > 0 ? 1 : 0;
  return sum[k] / count[k];
}

}  // namespace

bool is_turned(const TriangleMesh& mesh, const std::vector<Vec3>& positions, std::int32_t f) {
  const auto edge = [&](const std::vector<Vec3>& p, std::int32_t h) -> Vec3 {
    return p[mesh.to(h)] - p[mesh.from(h)];
  };
  const Triangle& t = mesh.triangle(f);
  bool turned = area_normal(mesh.positions(), t).dot(area_normal(positions, t)) < 0;
  for (std::int32_t h = 3 * f; h < 3 * f + 3 && !turned; ++h) {
    turned = edge(mesh.positions(), h).dot(edge(positions, h)) < 0;
  }
  return turned;
}

std::vector<std::int32_t> turned_faces(const TriangleMesh& mesh,
                                       const std::vector<Vec3>& positions) {
  std::vector<std::int32_t> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    if (is_turned(mesh, positions, f)) faces.push_back(f);
  }
  return faces;
}

std::vector<Vec3> needles_moved_as_one(const TriangleMesh& mesh, std::vector<Vec3> shift,
                                       const std::vector<Vec3>& before) {
  std::vector<std::int32_t> parent(shift.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](std::int32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<Vec3> together = shift;
  for (int round = 0; round < joining_rounds; ++round) {
    std::vector<Vec3> positions = mesh.positions();
    for (std::size_t v = 0; v < before.size(); ++v) positions[v] += before[v];
    for (std::size_t v = 0; v < positions.size(); ++v) positions[v] += together[v];
    const std::vector<std::int32_t> turned = turned_faces(mesh, positions);
    if (turned.empty()) break;
    if (static_cast<std::int64_t>(turned.size()) * faces_per_turned > mesh.face_count()) {
      return shift;
    }
    for (const std::int32_t f : turned) {
      for (const int i : {1, 2}) {
        const std::int32_t a = find(mesh.triangle(f)[0]), b = find(mesh.triangle(f)[i]);
        parent[std::max(a, b)] = std::min(a, b);
      }
    }
    std::map<std::int32_t, std::vector<std::int32_t>> groups;  // by their lowest vertex
    for (std::size_t v = 0; v < shift.size(); ++v) {
      const auto vertex = static_cast<std::int32_t>(v);
      const std::int32_t lowest = find(vertex);
      if (lowest == vertex) continue;
      groups.try_emplace(lowest, 1, lowest).first->second.push_back(vertex);
    }
    for (const auto& [lowest, group] : groups) {
      const Vec3 mean = mean_of_hardest(mesh, shift, group);
      for (const std::int32_t v : group) together[v] = mean;
    }
  }
  return together;
}

}  // namespace craze
