// What the paper says of its cracks, as numbers measured on runs. Tests hold small runs to them;
// benchmarks/claims.cpp measures larger ones and prints the table of docs/claims.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "craze/engine/initial_fields.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/mesh/tangent_frame.h"
#include "craze/model/crack_network.h"
#include "craze/model/failure/direction_bias.h"
#include "craze/model/screening.h"
#include "craze/model/sources/curvature.h"
#include "craze/presets.h"
#include "craze/products/statistics/statistics.h"
#include "craze/shapes.h"
#include "model/border_angles.h"

namespace craze::test {

/// A finished run and the mesh it began with.
struct Cracked {
  TriangleMesh before;
  Simulation simulation;
};

/// Cracks a sound mesh by a recipe as run() does.
inline Cracked crack(SurfaceMesh input, Recipe recipe, std::uint64_t seed,
                     const Textures& textures = {}) {
  recipe.simulation.seed = seed;
  recipe.simulation = resolve_lengths(recipe.simulation, bounding_diagonal(input.positions));
  const SimulationSurface surface = simulation_surface(std::move(input), recipe, {});
  TriangleMesh mesh(surface.mesh.positions, surface.mesh.triangles);
  SimulationFields fields = initial_fields(surface, mesh, recipe.simulation, textures, {});
  Cracked cracked{mesh, {mesh, std::move(fields), recipe.simulation, {}}};
  cracked.simulation.run({});
  return cracked;
}

inline Cracked crack(const std::string& shape, const Recipe& recipe, std::uint64_t seed) {
  return crack(make_shape(shape), recipe, seed);
}

/// A preset with a spacing, given as part of the diagonal, on the mesh as it is.
inline Recipe coarse_preset(const char* name, double relative_spacing) {
  Recipe recipe = read_preset(name);
  recipe.mesh.edge.kind = EdgeLength::Kind::keep;
  recipe.simulation.layer.relative_spacing = relative_spacing;
  return recipe;
}

/// Length over chord of the cracks between their junctions.
inline double tortuosity(const Cracked& cracked) {
  StatisticsOptions options;
  options.bootstrap.resamples = 0;
  const Simulation& s = cracked.simulation;
  return compute_statistics(graph_from_network(crack_network(s), s.mesh()), options)
      .tortuosity.value;
}

/// Mean turn from each crack edge to the next one, degrees.
inline double mean_turn(const CrackNetwork& network) {
  std::vector<std::vector<std::int32_t>> at(network.nodes.size());
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    at[network.edges[e].a].push_back(static_cast<std::int32_t>(e));
    at[network.edges[e].b].push_back(static_cast<std::int32_t>(e));
  }
  double sum = 0;
  int count = 0;
  for (std::size_t n = 0; n < at.size(); ++n) {
    if (at[n].size() != 2) continue;
    Vec3 away[2];
    for (int i = 0; i < 2; ++i) {
      const CrackEdge& e = network.edges[at[n][i]];
      const std::int32_t other = e.a == static_cast<std::int32_t>(n) ? e.b : e.a;
      away[i] = (network.nodes[other].position - network.nodes[n].position).normalized();
    }
    sum += std::acos(std::clamp(-away[0].dot(away[1]), -1.0, 1.0)) * 180 / std::numbers::pi;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

/// Crack length per area in the quarter of the surface where √(κ₁² + κ₂²) is largest, over that in
/// the quarter where it is smallest.
inline double density_contrast(const Cracked& cracked) {
  const TriangleMesh& mesh = cracked.before;
  const auto faces = static_cast<std::size_t>(mesh.face_count());
  const auto curvature = vertex_curvature(mesh, 0, {});
  std::vector<double> bend(faces), length(faces, 0);
  for (std::size_t f = 0; f < faces; ++f) {
    for (const std::int32_t v : mesh.triangles()[f]) bend[f] += curvature[v].frobenius() / 3;
  }
  const CrackNetwork network = crack_network(cracked.simulation);
  for (const CrackEdge& e : network.edges) {
    length[e.face] += (network.nodes[e.b].position - network.nodes[e.a].position).norm();
  }
  std::vector<std::size_t> order(faces);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return bend[a] < bend[b]; });
  const double quarter = mesh.total_area() / 4;
  double flat_length = 0, flat_area = 0, curved_length = 0, curved_area = 0, walked = 0;
  for (const std::size_t f : order) {
    const double area = mesh.area(static_cast<std::int32_t>(f));
    if (walked < quarter) {
      flat_length += length[f];
      flat_area += area;
    } else if (walked >= 3 * quarter) {
      curved_length += length[f];
      curved_area += area;
    }
    walked += area;
  }
  return curved_length / curved_area / (flat_length / flat_area);
}

/// Mean of cos 2θ over crack length, θ the angle to the preferred principal direction, where the
/// surface has one: 1 for cracks along it, 0 for cracks without preference, −1 across.
inline double alignment(const Cracked& cracked) {
  const auto preferred = preferred_directions(vertex_curvature(cracked.before, 0, {}));
  const CrackNetwork network = crack_network(cracked.simulation);
  double sum = 0, total = 0;
  for (const CrackEdge& e : network.edges) {
    const PreferredDirection& p = preferred[cracked.before.triangle(e.face)[0]];
    if (p.confidence < 0.5) continue;
    const Vec3 d = network.nodes[e.b].position - network.nodes[e.a].position;
    const double length = d.norm(), cosine = d.normalized().dot(p.along);
    sum += length * (2 * cosine * cosine - 1);
    total += length;
  }
  return total > 0 ? sum / total : 0;
}

/// Mean of |degrees off the border's normal| of the cracks that end on a plate's border.
inline double off_border_normal(const Cracked& cracked, double reach) {
  const auto angles = border_angles(crack_network(cracked.simulation), reach, reach);
  double sum = 0;
  for (const double angle : angles) sum += std::abs(angle);
  return angles.empty() ? std::nan("") : sum / static_cast<double>(angles.size());
}

/// Of a struck plate: the share of the crack length that had opened when half of what runs within
/// 30° of the rays from `center` had, for the part within 30° of the rings.
inline double rings_before_half_the_rays(const Cracked& cracked, const Vec3& center) {
  struct Piece {
    double time, length;
    bool ray;
  };
  std::vector<Piece> pieces;
  double rays = 0, rings = 0;
  const CrackNetwork network = crack_network(cracked.simulation);
  for (const CrackEdge& e : network.edges) {
    const Vec3 &a = network.nodes[e.a].position, &b = network.nodes[e.b].position;
    const double length = (b - a).norm();
    const double cosine = std::abs(((a + b) / 2 - center).normalized().dot((b - a) / length));
    const double steep = std::cos(std::numbers::pi / 6);
    if (cosine < steep && cosine > std::sqrt(1 - steep * steep)) continue;
    const bool ray = cosine >= steep;
    (ray ? rays : rings) += length;
    pieces.push_back({e.time, length, ray});
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.time < b.time; });
  double open_rays = 0, open_rings = 0;
  for (const Piece& piece : pieces) {
    (piece.ray ? open_rays : open_rings) += piece.length;
    if (open_rays >= rays / 2) break;
  }
  return rings > 0 ? open_rings / rings : 0;
}

/// The farthest that any node of the input is from where it was after the run, over the diagonal.
inline double farthest_move(const Cracked& cracked) {
  double farthest = 0;
  for (std::int32_t v = 0; v < cracked.before.vertex_count(); ++v) {
    farthest = std::max(
        farthest, (cracked.simulation.mesh().position(v) - cracked.before.position(v)).norm());
  }
  return farthest / bounding_diagonal(cracked.before.positions());
}

}  // namespace craze::test
