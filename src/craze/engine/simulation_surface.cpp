#include "craze/engine/simulation_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "craze/engine/check_scale.h"
#include "craze/mesh/numbering/spatial_numbering.h"
#include "craze/mesh/remesh/remesh.h"
#include "craze/model/sources/input_fields.h"
#include "craze/model/sources/painted_multiplier.h"

namespace craze {

namespace {

// Of the screening length: fine enough to resolve how a crack unloads its surroundings.
constexpr double edge_per_screening_length = 0.25;

// Of the edge that the pattern needs: a mesh whose mean edge is below is a scan, with more
// triangles than the pattern can tell apart, and bumps that are none of its business.
constexpr double scan_edge = 0.5;
// Of that edge: how far the mesh of a scan may be from it, so that bumps of that height go.
constexpr double scan_distance = 0.5;

/// The edge length to remesh to, 0: not at all; and how.
RemeshOptions remesh_options(const SurfaceMesh& surface, const Period& period, const Recipe& recipe,
                             double coarseness = 1) {
  RemeshOptions options;
  options.period = period;
  options.seed = recipe.simulation.seed;
  const EdgeLength& edge = recipe.mesh.edge;
  if (edge.kind != EdgeLength::Kind::automatic) {
    options.target_edge = edge.length;
    options.coarsen = edge.kind == EdgeLength::Kind::given;
    return options;
  }
  const double target =
      coarseness * edge_per_screening_length * recipe.simulation.layer.screening_length;
  const double mean = mean_edge(surface.positions, surface.triangles, period);
  // The input keeps its own triangles only where cracks are carried back onto them.
  options.coarsen = recipe.mesh.output == OutputMesh::asset && mean < scan_edge * target;
  if (options.coarsen) options.max_distance = scan_distance * target;
  if (target > 0 && (mean > target || options.coarsen)) options.target_edge = target;
  return options;
}

/// #halfedges: the cotangent of the angle opposite, kept positive.
std::vector<double> opposite_cotangents(const TriangleMesh& mesh) {
  constexpr double least = 1e-3, most = 1e3;
  std::vector<double> cotangents;
  cotangents.reserve(3 * static_cast<std::size_t>(mesh.face_count()));
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const Vec3& apex = mesh.position(mesh.from(TriangleMesh::prev(h)));
    const Vec3 a = mesh.position(mesh.from(h)) - apex, b = mesh.position(mesh.to(h)) - apex;
    const double sine = a.cross(b).norm(), cosine = a.dot(b);
    cotangents.push_back(cosine > least * sine ? std::min(cosine / sine, most) : least);
  }
  return cotangents;
}

/// Positions without bumps finer than `width`: each vertex goes halfway to the mean of its
/// neighbours, over and over, which spreads it by width/2 in the end. Borders stay. The mean is
/// weighted by cotangents, so that vertices go across the surface and hardly along it [Desbrun et
/// al.: Implicit Fairing of Irregular Meshes, 1999]: what is straight on the one surface is nearly
/// so on the other.
std::vector<Vec3> without_bumps(const SurfaceMesh& surface, double width) {
  constexpr double most_rounds = 100;
  const double ratio = width / mean_edge(surface.positions, surface.triangles);
  const int rounds = static_cast<int>(std::min(std::ceil(ratio * ratio), most_rounds));
  const TriangleMesh mesh(surface.positions, surface.triangles);
  const std::vector<double> cotangents = opposite_cotangents(mesh);
  std::vector<Vec3> now = surface.positions, next = now;
  for (int round = 0; round < rounds; ++round) {
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.first_halfedge(v) < 0 || mesh.is_open_vertex(v)) continue;
      Vec3 sum = Vec3::Zero();
      double weights = 0;
      mesh.for_each_outgoing(v, [&](std::int32_t h) {
        const double weight = cotangents[h] + cotangents[mesh.opposite(h)];
        sum += weight * now[mesh.to(h)];
        weights += weight;
      });
      next[v] = 0.5 * (now[v] + sum / weights);
    }
    now.swap(next);
  }
  return now;
}

/// What the simulation's mesh is made from; empty: the surface itself.
std::vector<Vec3> smooth_positions(const SurfaceMesh& surface, const RemeshOptions& options) {
  if (!(options.max_distance > 0)) return {};
  return without_bumps(surface, options.target_edge);
}

/// #F, 1 for marked faces and those that share a vertex with one: a face of the finer mesh takes
/// its mark from where its middle is, and may reach over.
std::vector<std::uint8_t> touching_faces(const SurfaceMesh& mesh,
                                         const std::vector<double>& marks) {
  std::vector<char> touched(mesh.positions.size(), 0);
  for (std::size_t f = 0; f < marks.size(); ++f) {
    for (const std::int32_t v : mesh.triangles[f]) touched[v] = touched[v] || marks[f] != 0;
  }
  std::vector<std::uint8_t> faces;
  for (const Triangle& t : mesh.triangles) {
    faces.push_back(touched[t[0]] || touched[t[1]] || touched[t[2]] ? 1 : 0);
  }
  return faces;
}

}  // namespace

double mean_edge(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                 const Period& period) {
  double sum = 0;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      sum += period.shortest(positions[t[(i + 1) % 3]] - positions[t[i]]).norm();
    }
  }
  return sum / (3 * static_cast<double>(triangles.size()));
}

std::vector<Vec3> smooth_asset(const SurfaceMesh& asset, const Recipe& recipe, double coarseness) {
  const RemeshOptions options = remesh_options(asset, {}, recipe, coarseness);
  SurfaceMesh surface;
  surface.positions = asset.positions;
  surface.triangles = asset.triangles;
  const Numbering numbering = spatial_numbering(surface.positions, surface.triangles);
  renumber(surface, numbering);
  std::vector<Vec3> positions = smooth_positions(surface, options);
  reorder(positions, inverse(numbering).vertices);
  return positions;
}

SimulationSurface simulation_surface(SurfaceMesh repaired, const Recipe& recipe,
                                     const Context& context, const Period& period,
                                     double coarseness) {
  const RemeshOptions options = remesh_options(repaired, period, recipe, coarseness);
  check_scale(repaired, recipe, options.target_edge, physical_memory(), period);
  SimulationSurface surface;
  surface.period = period;
  Numbering numbering = spatial_numbering(repaired.positions, repaired.triangles);
  renumber(repaired, numbering);
  if (options.target_edge == 0) {
    surface.mesh = std::move(repaired);
    surface.numbering = std::move(numbering);
    return surface;
  }

  const MaterialParameters& material = recipe.simulation.material;
  const bool may_forbid = !material.attribute.empty() || !recipe.simulation.layer.attribute.empty();
  if (may_forbid) {
    // Remeshing carries an attribute of the faces; taken off again, it is no part of the mesh.
    const TriangleMesh topology(repaired.positions, repaired.triangles);
    const auto zero =
        faces_with_zero_attribute(topology, recipe.simulation, input_fields(repaired));
    repaired.face_attributes.push_back(
        {"forbidden", 1, std::vector<double>(zero.begin(), zero.end())});
  }
  // Without source_faces of its own the surface is numbered by its faces.
  std::vector<std::int32_t> source_faces = std::exchange(repaired.source_faces, {});
  std::vector<Vec3> positions = smooth_positions(repaired, options);
  if (!positions.empty()) positions.swap(repaired.positions);
  surface.mesh = remesh(repaired, options, context);
  renumber(surface.mesh, spatial_numbering(surface.mesh.positions, surface.mesh.triangles));
  if (!positions.empty()) {
    surface.smooth = std::exchange(repaired.positions, std::move(positions));
  }
  surface.asset_face = surface.mesh.source_faces;
  for (std::int32_t& f : surface.asset_face) f = numbering.faces[f];
  if (source_faces.empty()) {
    surface.mesh.source_faces = surface.asset_face;
  } else {
    for (std::int32_t& f : surface.mesh.source_faces) f = source_faces[f];
  }
  if (may_forbid) {
    surface.forbidden = touching_faces(surface.mesh, surface.mesh.face_attributes.back().values);
    surface.mesh.face_attributes.pop_back();
    repaired.face_attributes.pop_back();
  }
  if (recipe.mesh.output == OutputMesh::asset) {
    repaired.source_faces = std::move(source_faces);
    const Numbering back = inverse(numbering);
    renumber(repaired, back);
    reorder(surface.smooth, back.vertices);
    surface.asset = std::move(repaired);
  }
  return surface;
}

}  // namespace craze
