#include "craze/engine/asset/carry_field.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "craze/base/segment_distance.h"
#include "craze/mesh/closest_point.h"

namespace craze {

namespace {

/// #V: the lowest vertex of each vertex's part. Parts are joined by vertices.
std::vector<std::int32_t> parts_of(const CutAsset& cut) {
  std::vector<std::int32_t> parent(cut.positions.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](std::int32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : cut.triangles) {
    for (const int i : {1, 2}) {
      const std::int32_t a = find(t[0]), b = find(t[i]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = find(static_cast<std::int32_t>(v));
  return parent;
}

/// #V: the simulation's part that most crack sides of the vertex's part name; −1 where none does.
std::vector<std::int32_t> matching_parts(const CutAsset& cut, const FieldSource& source) {
  const std::vector<std::int32_t> part = parts_of(cut);
  std::vector<std::pair<std::int32_t, std::int32_t>> votes;  // (asset's part, simulation's)
  for (const CutEdge& edge : cut.edges) {
    for (std::size_t s = 0; s < 2; ++s) {
      const std::int32_t face = source.sides[edge.curve_edge].face[s];
      if (edge.side[s] < 0 || face < 0) continue;
      votes.emplace_back(part[cut.triangles[edge.side[s] / 3][0]], source.parts[face]);
    }
  }
  std::sort(votes.begin(), votes.end());
  std::vector<std::int32_t> match(cut.positions.size(), -1);
  std::vector<std::ptrdiff_t> most(cut.positions.size(), 0);
  for (auto i = votes.begin(), j = i; i != votes.end(); i = j) {
    j = std::upper_bound(i, votes.end(), *i);
    if (j - i <= most[i->first]) continue;
    most[i->first] = j - i;
    match[i->first] = i->second;
  }
  for (std::size_t v = 0; v < match.size(); ++v) match[v] = match[part[v]];
  return match;
}

/// The field at the point of the mesh nearest to p that is found by going from face to face, each
/// nearer than the last, over no open edge.
Vec3 walked_to(const Vec3& p, std::int32_t face, const FieldSource& source) {
  const auto nearest = [&](std::int32_t f) {
    const Triangle& t = source.mesh.triangle(f);
    const Vec3 &a = source.mesh.position(t[0]), &b = source.mesh.position(t[1]),
               &c = source.mesh.position(t[2]);
    Vec3 w = nearest_weights(p, a, b, c);
    if (!w.allFinite()) w = Vec3::UnitX();
    return std::pair<double, Vec3>{(w[0] * a + w[1] * b + w[2] * c - p).norm(), w};
  };
  std::pair<double, Vec3> best = nearest(face);
  for (bool nearer = best.first > 0; nearer;) {
    nearer = false;
    for (std::int32_t h = 3 * face; h < 3 * face + 3; ++h) {
      if (source.mesh.is_open(h)) continue;
      const std::int32_t beyond = TriangleMesh::face_of(source.mesh.opposite(h));
      const std::pair<double, Vec3> other = nearest(beyond);
      if (!(other.first < best.first)) continue;
      best = other;
      face = beyond;
      nearer = true;
      break;
    }
  }
  const Triangle& t = source.mesh.triangle(face);
  return best.second[0] * source.field[t[0]] + best.second[1] * source.field[t[1]] +
         best.second[2] * source.field[t[2]];
}

}  // namespace

std::vector<Vec3> carry_field(const CutAsset& cut, const std::vector<Vec3>& positions,
                              const CrackCurves& curves, const FieldSource& source) {
  std::vector<Vec3> values(cut.positions.size(), Vec3::Zero());
  std::vector<std::int32_t> count(cut.positions.size(), 0);
  for (const CutEdge& edge : cut.edges) {
    const auto& ends = curves.edges[edge.curve_edge];
    const Vec3 &a = positions[cut.point_vertex[ends[0]]], &b = positions[cut.point_vertex[ends[1]]];
    for (std::size_t s = 0; s < 2; ++s) {
      const std::int32_t h = edge.side[s];
      if (h < 0) continue;
      const CrackSides& sides = source.sides[edge.curve_edge];
      const std::array<Vec3, 2>& of_end = sides.value[s];
      for (const std::int32_t v :
           {cut.triangles[h / 3][h % 3], cut.triangles[h / 3][(h + 1) % 3]}) {
        ++count[v];
        if (source.is_beside && sides.face[s] >= 0) {
          values[v] += walked_to(positions[v], sides.face[s], source);
          continue;
        }
        const double t = nearest_on_segment(positions[v], a, b);
        values[v] += (1 - t) * of_end[0] + t * of_end[1];
      }
    }
  }
  const std::vector<std::int32_t> match = matching_parts(cut, source);
  const ClosestPoint tree(source.mesh.positions(), source.mesh.triangles(), source.parts);
  std::vector<Vec3> normal(cut.positions.size(), Vec3::Zero());
  for (const Triangle& t : cut.triangles) {
    const Vec3& p = positions[t[0]];
    const Vec3 n = (positions[t[1]] - p).cross(positions[t[2]] - p);
    for (const std::int32_t v : t) normal[v] += n;
  }
  std::int32_t hint = -1;
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (count[v] > 0) {
      values[v] /= count[v];
      continue;
    }
    ClosestPoint::Hit hit = tree.find(positions[v], {normal[v], match[v], hint});
    if (hit.face < 0) hit = tree.find(positions[v], {Vec3::Zero(), match[v], -1});
    hint = hit.face;
    if (hit.face < 0) continue;
    const Triangle& t = source.mesh.triangle(hit.face);
    for (int i = 0; i < 3; ++i) values[v] += hit.weights[i] * source.field[t[i]];
  }
  return values;
}

}  // namespace craze
