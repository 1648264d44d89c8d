#include "craze/io/polygons/unify_corners.h"

#include <algorithm>
#include <numeric>
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
    std::vector<std::int32_t> at(begin.begin(), begin.end() - 1);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      corners[at[mesh.triangles[c / 3][c % 3]]++] = static_cast<std::int32_t>(c);
    }
  }
  std::vector<std::int32_t> begin, corners;
};

/// Compares what two corners carry.
class CornerValues {
 public:
  /// Empty: not compared.
  CornerValues(const std::vector<Vec2>& uvs, const std::vector<Vec3>& normals)
      : uvs_(uvs), normals_(normals) {}

  bool equal(std::int32_t a, std::int32_t b) const {
    return (uvs_.empty() || uvs_[a] == uvs_[b]) && (normals_.empty() || normals_[a] == normals_[b]);
  }
  bool less(std::int32_t a, std::int32_t b) const {
    if (!uvs_.empty()) {
      const Vec2 &p = uvs_[a], &q = uvs_[b];
      if (p != q) return std::tie(p.x(), p.y()) < std::tie(q.x(), q.y());
    }
    if (!normals_.empty()) {
      const Vec3 &p = normals_[a], &q = normals_[b];
      if (p != q) return std::tie(p.x(), p.y(), p.z()) < std::tie(q.x(), q.y(), q.z());
    }
    return a < b;
  }

 private:
  const std::vector<Vec2>& uvs_;
  const std::vector<Vec3>& normals_;
};

UnifiedCorners unify(const SurfaceMesh& mesh, const std::vector<Vec2>& corner_uvs,
                     const std::vector<Vec3>& corner_normals) {
  const bool uvs = !corner_uvs.empty(), normals = !corner_normals.empty();
  const CornerValues values(corner_uvs, corner_normals);

  UnifiedCorners unified;
  unified.triangles = mesh.triangles;
  const auto count = static_cast<std::int32_t>(mesh.positions.size());
  unified.sources.resize(mesh.positions.size());
  std::iota(unified.sources.begin(), unified.sources.end(), 0);
  if (uvs) unified.uvs.assign(count, Vec2::Zero());
  if (normals) unified.normals.assign(count, Vec3::UnitZ());
  if (!uvs && !normals) return unified;

  // Corners of equal values stand together after sorting; each such group is one vertex.
  const VertexCorners around(mesh);
  std::vector<std::int32_t> sorted, first_of_group;
  const auto take = [&](std::int32_t vertex, std::int32_t corner) {
    if (uvs) unified.uvs[vertex] = corner_uvs[corner];
    if (normals) unified.normals[vertex] = corner_normals[corner];
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

}  // namespace

UnifiedCorners unify_corners(const SurfaceMesh& mesh, const CornerKinds& kinds) {
  const std::vector<Vec2> no_uvs;
  const std::vector<Vec3> no_normals;
  return unify(mesh, kinds.uvs ? mesh.corner_uvs : no_uvs,
               kinds.normals ? mesh.corner_normals : no_normals);
}

UnifiedCorners unify_corners(const SurfaceMesh& mesh, const std::vector<Vec3>& normals) {
  return unify(mesh, mesh.corner_uvs, normals);
}

}  // namespace craze
