// Assets of every kind and random curves on them, for the tests that cut.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "craze/base/random.h"
#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/cut_asset.h"
#include "craze/shapes.h"

namespace craze::test {

/// The surface of the cells of an n×n×n block that `solid` keeps: right angles, tunnels, and edges
/// of four faces where cells meet in a line.
template <class Solid>
SurfaceMesh block_surface(int n, Solid&& solid) {
  SurfaceMesh mesh;
  std::map<std::array<int, 3>, std::int32_t> vertex;
  const auto at = [&](std::array<int, 3> p) {
    const auto [slot, fresh] =
        vertex.try_emplace(p, static_cast<std::int32_t>(mesh.positions.size()));
    if (fresh) mesh.positions.emplace_back(p[0], p[1], p[2]);
    return slot->second;
  };
  const auto is_solid = [&](const std::array<int, 3>& c) {
    for (const int x : c) {
      if (x < 0 || x >= n) return false;
    }
    return static_cast<bool>(solid(c[0], c[1], c[2]));
  };
  for (int k = 0; k < n * n * n; ++k) {
    const std::array<int, 3> cell{k % n, k / n % n, k / n / n};
    if (!is_solid(cell)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        std::array<int, 3> beside = cell;
        beside[axis] += side == 1 ? 1 : -1;
        if (is_solid(beside)) continue;
        std::array<std::array<int, 3>, 4> q;
        for (int i = 0; i < 4; ++i) {
          q[i] = cell;
          q[i][axis] += side;
          q[i][(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
          q[i][(axis + 2) % 3] += i >= 2 ? 1 : 0;
        }
        if (side == 0) std::swap(q[1], q[3]);
        mesh.triangles.push_back({at(q[0]), at(q[1]), at(q[2])});
        mesh.triangles.push_back({at(q[0]), at(q[2]), at(q[3])});
      }
    }
  }
  return mesh;
}

/// A cube of 3×3×3 cells with a tunnel along each axis: genus 5.
inline SurfaceMesh sponge() {
  return block_surface(3, [](int x, int y, int z) { return (x == 1) + (y == 1) + (z == 1) < 2; });
}

/// Two cubes that share one edge only, of four faces.
inline SurfaceMesh touching_cubes() {
  return block_surface(2, [](int x, int y, int z) { return x == y && z == 0; });
}

/// Squeezed along one axis: every triangle a needle.
inline SurfaceMesh needles(SurfaceMesh mesh, double height) {
  for (Vec3& p : mesh.positions) p.y() *= height;
  return mesh;
}

inline SurfaceMesh moved(SurfaceMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

/// Every face with vertices of its own, as files with hard edges have.
inline SurfaceMesh unwelded(const SurfaceMesh& mesh) {
  SurfaceMesh apart;
  for (const Triangle& t : mesh.triangles) {
    const auto v = static_cast<std::int32_t>(apart.positions.size());
    for (const std::int32_t c : t) apart.positions.push_back(mesh.positions[c]);
    apart.triangles.push_back({v, v + 1, v + 2});
  }
  return apart;
}

/// UVs and normals that differ at every corner, a vertex attribute linear in space and colours.
inline SurfaceMesh dressed(SurfaceMesh mesh) {
  Random random(17);
  mesh.corner_uvs.clear();
  mesh.corner_normals.clear();
  for (std::size_t c = 0; c < 3 * mesh.triangles.size(); ++c) {
    mesh.corner_uvs.emplace_back(random.uniform(), random.uniform());
    mesh.corner_normals.push_back(Vec3(random.normal(), random.normal(), 3).normalized());
  }
  Attribute weight{"weight", 2, {}}, part{"part", 1, {}};
  for (const Vec3& p : mesh.positions) {
    weight.values.push_back(p.x() + 2 * p.y() - p.z());
    weight.values.push_back(random.uniform());
    mesh.vertex_colors.push_back({float(random.uniform()), float(random.uniform()), 0.25f, 1});
  }
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    part.values.push_back(static_cast<double>(f));
    mesh.face_materials.push_back(static_cast<std::int32_t>(f % 3));
    mesh.face_objects.push_back(static_cast<std::int32_t>(f % 2));
  }
  mesh.material_names = {"a", "b", "c"};
  mesh.object_names = {"cup", "saucer"};
  mesh.vertex_attributes = {std::move(weight)};
  mesh.face_attributes = {std::move(part)};
  return mesh;
}

/// Weights of a point of a face: anywhere, on a vertex, on an edge, or a breath beside them.
inline Vec3 random_weights(Random& random) {
  Vec3 w;
  const int i = static_cast<int>(random.below(3));
  const double breath = std::pow(10.0, -random.uniform(1, 14));
  switch (random.below(6)) {
    case 0:
      w = Vec3::Unit(i);
      break;
    case 1:
      w = Vec3::Unit(i) * random.uniform() + Vec3::Unit((i + 1) % 3) * 0.3;
      break;
    case 2:
      w = Vec3::Unit(i) + breath * Vec3(random.uniform(), random.uniform(), random.uniform());
      break;
    case 3:
      w = Vec3(random.uniform(), random.uniform(), random.uniform());
      w[i] *= breath;
      break;
    default:
      w = Vec3(random.uniform(), random.uniform(), random.uniform());
  }
  return w / w.sum();
}

struct RandomCurves {
  int chains = 6;
  int length = 8;  ///< edges per chain
  int stride = 3;  ///< faces from one point to the next, at most
};

/// Vertices at one position are one place.
inline CutAsset cut(const SurfaceMesh& asset, const CrackCurves& curves,
                    const CutOptions& options) {
  return cut_asset(asset, AssetTopology(asset.positions, asset.triangles), curves, options, {});
}

/// Chains of points from face to neighbouring face, some of which start on a point of another one.
inline CrackCurves random_curves(const SurfaceMesh& asset, Random& random,
                                 const RandomCurves& options) {
  const AssetTopology topology(asset.positions, asset.triangles);
  CrackCurves curves;
  for (int chain = 0; chain < options.chains; ++chain) {
    std::int32_t last;
    if (!curves.points.empty() && random.below(2) == 0) {
      last = static_cast<std::int32_t>(random.below(curves.points.size()));
    } else {
      last = static_cast<std::int32_t>(curves.points.size());
      curves.points.push_back({static_cast<std::int32_t>(random.below(asset.triangles.size())),
                               random_weights(random)});
    }
    for (int k = 0; k < options.length; ++k) {
      std::int32_t face = curves.points[last].face;
      for (std::uint64_t step = random.below(options.stride + 1); step > 0; --step) {
        const auto h = static_cast<std::int32_t>(3 * face + random.below(3));
        if (topology.edge(h) < 0) continue;
        const HalfedgeRange sides = topology.sides(topology.edge(h));
        face = sides.begin()[random.below(sides.size())] / 3;
      }
      const auto next = static_cast<std::int32_t>(curves.points.size());
      curves.points.push_back({face, random_weights(random)});
      curves.edges.push_back({last, next});
      last = next;
    }
  }
  return curves;
}

}  // namespace craze::test
