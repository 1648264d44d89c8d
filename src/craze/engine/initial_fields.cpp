#include "craze/engine/initial_fields.h"

#include <algorithm>
#include <limits>

#include "craze/base/elementary.h"
#include "craze/base/random.h"
#include "craze/error.h"
#include "craze/mesh/remesh/feature_lines.h"
#include "craze/mesh/tangent_frame.h"
#include "craze/model/failure/direction_bias.h"
#include "craze/model/relaxation/relaxation.h"
#include "craze/model/sources/correlated_noise.h"
#include "craze/model/sources/curvature.h"
#include "craze/model/sources/input_fields.h"
#include "craze/model/sources/onset.h"
#include "craze/model/sources/painted_multiplier.h"
#include "craze/model/sources/stress_sources.h"

namespace craze {

namespace {

// Names the random numbers of the strength's scatter, apart from those of the stress.
constexpr std::uint64_t scatter_stream = 0x5ca77e4;
constexpr double held_above = 0.5;
// Degrees between the normals of two faces at a fold.
constexpr double fold_angle = 40;

std::vector<Sym3> in_world(const TriangleMesh& mesh, const std::vector<Sym2>& tensors,
                           double factor) {
  std::vector<Sym3> world(tensors.size());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.area(f) > 0) world[f] = factor * to_world(tensors[f], tangent_frame(mesh, f));
  }
  return world;
}

/// Log-normal with mean 1, so never negative; its relative deviation is about `scatter`.
void scatter_strength(std::vector<double>& scale, const TriangleMesh& mesh,
                      const SimulationParameters& p, const Context& context) {
  const double s = p.material.scatter;
  if (s == 0) return;
  const Random random(p.seed, scatter_stream);
  const std::vector<double> noise = face_noise(mesh, p.material.scatter_length, random, context);
  for (std::size_t f = 0; f < scale.size(); ++f)
    scale[f] *= elementary::exp(s * noise[f] - 0.5 * s * s);
}

std::vector<double> toughness_scale(const TriangleMesh& mesh, const SimulationParameters& p,
                                    const InputFields& input, const SimulationSurface& surface,
                                    const Context& context) {
  std::vector<double> scale = material_multiplier(mesh, p.material, input).face;
  scale.resize(static_cast<std::size_t>(mesh.face_count()), 1);
  scatter_strength(scale, mesh, p, context);
  const std::vector<std::uint8_t> forbidden = forbidden_faces(mesh, p, input);
  for (std::size_t f = 0; f < forbidden.size(); ++f) {
    const bool in_input = !surface.forbidden.empty() && surface.forbidden[f];
    if (forbidden[f] || in_input) scale[f] = std::numeric_limits<double>::infinity();
  }
  for (std::size_t f = 0; f < surface.mask.size(); ++f) {
    const double m = surface.mask[f];
    scale[f] = m > 0 ? scale[f] / m : std::numeric_limits<double>::infinity();
  }
  return scale;
}

std::vector<double> separation_scale(const TriangleMesh& mesh, const SimulationParameters& p,
                                     const Context& context) {
  if (p.material.curvature_scale == CurvatureScale::none) return {};
  const std::vector<double> vertex = curvature_factors(
      vertex_curvature(mesh, p.stress.curvature_radius, context), p.material.curvature_scale);
  std::vector<double> face(static_cast<std::size_t>(mesh.face_count()));
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle& t = mesh.triangle(f);
    face[f] = (vertex[t[0]] + vertex[t[1]] + vertex[t[2]]) / 3;
  }
  return face;
}

/// Per face the principal direction that its first corner's curvature prefers.
std::vector<PreferredDirection> preferred_per_face(const TriangleMesh& mesh,
                                                   const SimulationParameters& p,
                                                   const Context& context) {
  if (p.material.bias == 0) return {};
  const std::vector<PreferredDirection> vertex =
      preferred_directions(vertex_curvature(mesh, p.stress.curvature_radius, context));
  std::vector<PreferredDirection> face;
  face.reserve(static_cast<std::size_t>(mesh.face_count()));
  for (const Triangle& t : mesh.triangles()) face.push_back(vertex[t[0]]);
  return face;
}

/// κ = 1/ℓ², so that a painted factor m on the spacing, and with it on ℓ, is 1/m² on κ. Where it is
/// 0 no crack runs and the layer's adhesion stays as it is. An ℓ far below the mesh's edges acts
/// like one of a part of them, and is taken as that: where a mask fades to 0, κ would grow without
/// bound, and Euler steps would have to shrink with it.
std::vector<double> adhesion_scale(const TriangleMesh& mesh, const SimulationParameters& p,
                                   const InputFields& input) {
  if (p.layer.attribute.empty() && p.layer.texture.empty()) return {};
  std::vector<double> scale = spacing_multiplier(mesh, p.layer, input).face;
  constexpr double shortest = 0.25;  // ℓ, in mean edges
  const double length = p.layer.screening_length;
  const double least =
      length > 0
          ? std::min(1.0, shortest * mean_edge(mesh.positions(), mesh.triangles(), mesh.period()) /
                              length)
          : 0;
  for (double& m : scale) {
    const double bounded = std::max(m, least);
    m = m > 0 ? 1 / (bounded * bounded) : 1;
  }
  return scale;
}

std::vector<char> held_vertices(const TriangleMesh& mesh, const BoundaryParameters& boundary,
                                const InputFields& input) {
  const bool border = boundary.kind == BoundaryKind::fixed;
  if (!border && boundary.fixed_attribute.empty()) return {};
  std::vector<char> held(static_cast<std::size_t>(mesh.vertex_count()), 0);
  if (!boundary.fixed_attribute.empty()) {
    const std::vector<double> mask =
        scalar_per_vertex(mesh, input, boundary.fixed_attribute, "boundary.fixed_attribute");
    for (std::size_t v = 0; v < held.size(); ++v) held[v] = mask[v] > held_above;
  }
  for (std::int32_t v = 0; border && v < mesh.vertex_count(); ++v) {
    if (mesh.is_open_vertex(v)) held[v] = 1;
  }
  return held;
}

/// The vertices of folds and seams.
std::vector<char> pinned_vertices(const SurfaceMesh& surface, const TriangleMesh& mesh,
                                  const CrackParameters& crack) {
  if (crack.near_vertex != NearVertex::slide) return {};
  const std::vector<char> marks = feature_lines(surface, mesh, fold_angle);
  std::vector<char> pinned(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (marks[h] != no_feature) pinned[mesh.from(h)] = pinned[mesh.to(h)] = 1;
  }
  return pinned;
}

}  // namespace

GreyImage find_texture(const Textures& textures, const std::string& name, const char* key) {
  if (name.empty()) return {};
  const auto found = textures.find(name);
  if (found != textures.end()) return found->second;
  throw Error(ErrorKind::request, "no such picture", key, "\"" + name + "\" was not given");
}

SimulationFields initial_fields(const SimulationSurface& surface, const TriangleMesh& mesh,
                                const SimulationParameters& p, const Textures& textures,
                                const Context& context) {
  InputFields input = input_fields(surface.mesh);
  input.stress_texture = find_texture(textures, p.stress.texture, "stress.texture");
  input.material_texture = find_texture(textures, p.material.texture, "material.texture");
  input.layer_texture = find_texture(textures, p.layer.texture, "layer.texture");
  input.onset_texture =
      find_texture(textures, p.evolution.onset_texture, "evolution.onset_texture");

  SimulationFields fields;
  fields.stress =
      in_world(mesh, initial_stress(mesh, p.stress, p.impacts, p.seed, input, context), 1);
  if (p.evolution.curvature_growth != 0) {
    fields.growth = in_world(mesh, face_curvature(mesh, p.stress.curvature_radius, context),
                             p.evolution.curvature_growth);
    // Without steps, what grows is a source that the load factor scales like the others.
    if (running_engine(p) == Engine::quasistatic) {
      for (std::size_t f = 0; f < fields.stress.size(); ++f) fields.stress[f] += fields.growth[f];
      fields.growth.clear();
    }
  }
  fields.onset = onset_per_face(mesh, p, input);
  fields.toughness_scale = toughness_scale(mesh, p, input, surface, context);
  fields.separation_scale = separation_scale(mesh, p, context);
  fields.adhesion_scale = adhesion_scale(mesh, p, input);
  fields.preferred = preferred_per_face(mesh, p, context);
  fields.fixed = held_vertices(mesh, p.boundary, input);
  fields.pinned = pinned_vertices(surface.mesh, mesh, p.crack);
  return fields;
}

}  // namespace craze
