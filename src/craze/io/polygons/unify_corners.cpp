#include "craze/io/polygons/unify_corners.h"

#include <algorithm>
#include <tuple>

namespace craze {

namespace {

/// The corners around each vertex, in rising order: those of v are corners[begin[v]] …
/// corners[begin[v + 1]].
struct VertexCorners {
  explicit VertexCorners(const SurfaceMesh& mesh)
      : begin(mesh.positions.size() + 1, 0), corners(3 * mesh.triangles.size()) {
    for (const Triangle& t : mesh.triangles) {
      for (const std::int32_t v : t) ++begin[v + 1];
    }
    for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
    std::vector<std::size_t> at(begin.begin(), begin.end() - 1);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      corners[at[mesh.triangles[c / 3][c % 3]]++] = static_cast<std::int32_t>(c);
    }
  }
  std::vector<std::size_t> begin;
  std::vector<std::int32_t> corners;
};

/// Compares what two corners carry.
class CornerValues {
 public:
  CornerValues(const SurfaceMesh& mesh, bool uvs, bool normals)
      : mesh_(mesh), uvs_(uvs), normals_(normals) {}

  bool equal(std::int32_t a, std::int32_t b) const {
    return (!uvs_ || mesh_.corner_uvs[a] == mesh_.corner_uvs[b]) &&
           (!normals_ || mesh_.corner_normals[a] == mesh_.corner_normals[b]);
  }
  bool less(std::int32_t a, std::int32_t b) const {
    if (uvs_) {
      const Vec2 &p = mesh_.corner_uvs[a], &q = mesh_.corner_uvs[b];
      if (p != q) return std::tie(p.x(), p.y()) < std::tie(q.x(), q.y());
    }
    if (normals_) {
      const Vec3 &p = mesh_.corner_normals[a], &q = mesh_.corner_normals[b];
      if (p != q) return std::tie(p.x(), p.y(), p.z()) < std::tie(q.x(), q.y(), q.z());
    }
    return a < b;
  }

 private:
  const SurfaceMesh& mesh_;
  bool uvs_, normals_;
};

}  // namespace

UnifiedCorners unify_corners(const SurfaceMesh& mesh, const CornerKinds& kinds) {
  const bool uvs = kinds.uvs && !mesh.corner_uvs.empty();
  const bool normals = kinds.normals && !mesh.corner_normals.empty();
  const CornerValues values(mesh, uvs, normals);

  UnifiedCorners unified;
  unified.triangles = mesh.triangles;
  const auto count = static_cast<std::int32_t>(mesh.positions.size());
  for (std::int32_t v = 0; v < count; ++v) unified.sources.push_back(v);
  if (uvs) unified.uvs.assign(count, Vec2::Zero());
  if (normals) unified.normals.assign(count, Vec3::UnitZ());
  if (!uvs && !normals) return unified;

  // Corners of equal values stand together after sorting; each such group is one vertex.
  const VertexCorners around(mesh);
  std::vector<std::int32_t> sorted, first_of_group;
  const auto take = [&](std::int32_t vertex, std::int32_t corner) {
    if (uvs) unified.uvs[vertex] = mesh.corner_uvs[corner];
    if (normals) unified.normals[vertex] = mesh.corner_normals[corner];
  };
  for (std::int32_t v = 0; v < count; ++v) {
    sorted.assign(around.corners.begin() + static_cast<std::ptrdiff_t>(around.begin[v]),
                  around.corners.begin() + static_cast<std::ptrdiff_t>(around.begin[v + 1]));
    if (sorted.empty()) continue;
    const std::int32_t first = sorted.front();
    take(v, first);
    std::sort(sorted.begin(), sorted.end(),
              [&](std::int32_t a, std::int32_t b) { return values.less(a, b); });
    first_of_group.clear();
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const bool opens = i == 0 || !values.equal(sorted[i - 1], sorted[i]);
      if (opens && !values.equal(sorted[i], first)) first_of_group.push_back(sorted[i]);
    }
    std::sort(first_of_group.begin(), first_of_group.end());
    for (const std::int32_t leader : first_of_group) {
      const auto copy = static_cast<std::int32_t>(unified.sources.size());
      unified.sources.push_back(v);
      if (uvs) unified.uvs.emplace_back();
      if (normals) unified.normals.emplace_back();
      take(copy, leader);
      // The group lies between its leader and the first corner of other values.
      auto at = std::lower_bound(sorted.begin(), sorted.end(), leader,
                                 [&](std::int32_t a, std::int32_t b) { return values.less(a, b); });
      for (; at != sorted.end() && values.equal(*at, leader); ++at) {
        unified.triangles[*at / 3][*at % 3] = copy;
      }
    }
  }
  return unified;
}

}  // namespace craze
