#include "craze/products/opening/opened_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "craze/base/text/format.h"
#include "craze/engine/cracked_surface.h"
#include "craze/engine/roughness/crack_chains.h"
#include "craze/engine/run_outcome.h"
#include "craze/error.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/mesh/transfer_attributes.h"
#include "craze/products/chips/chipped_mesh.h"
#include "craze/products/faces/rough_faces.h"
#include "craze/products/maps/groove_sizes.h"
#include "craze/products/maps/map_cracks.h"
#include "craze/products/opening/aged_displacement.h"
#include "craze/products/opening/bend_refinement.h"
#include "craze/products/opening/curl.h"
#include "craze/products/opening/opened_attributes.h"
#include "craze/products/opening/turned_normals.h"
#include "craze/products/solids/inner_directions.h"
#include "craze/products/solids/solids.h"
#include "craze/recipe/idle_keys.h"

namespace craze {

namespace {

/// Of the diagonal.
constexpr double probe_depth = 0.005;

Attribute as_attribute(const std::vector<Vec3>& vectors) {
  Attribute attribute{"vectors", 3, {}};
  for (const Vec3& u : vectors) {
    attribute.values.insert(attribute.values.end(), u.data(), u.data() + 3);
  }
  return attribute;
}

std::vector<Vec3> as_vectors(const Attribute& attribute) {
  std::vector<Vec3> vectors;
  for (auto x = attribute.values.begin(); x != attribute.values.end(); x += 3) {
    vectors.emplace_back(x[0], x[1], x[2]);
  }
  return vectors;
}

/// #V of the mesh that was cut, or of what that was refined to: as the uncut surface has them, so
/// that each of its triangles has a flat inner side however it was cut.
std::vector<Vec3> outwards(const CrackedSurface& state, const TriangleMesh* refined,
                           const Threads& threads) {
  SurfaceMesh uncut;
  uncut.positions = state.surface->positions;
  uncut.triangles = state.surface->triangles;
  uncut.vertex_attributes = {as_attribute(inner_directions(uncut.positions, uncut.triangles))};
  SurfaceMesh cut = state.with_attributes(uncut, threads);
  if (refined) cut = transfer_attributes(cut, *refined, threads);
  return as_vectors(cut.vertex_attributes.front());
}

/// The mesh with chips in its rims, whose faces are parts of those of the cut mesh.
ChippedMesh chipped(const CrackedSurface& state, const TriangleMesh* refined,
                    const PostParameters& post, std::uint64_t seed,
                    std::vector<std::string>& warnings, const Context& context) {
  TriangleMesh mesh = refined ? *refined : state.mesh();
  if (!refined && !state.asset) mesh.be_own_source();
  const std::vector<MapCrack> cracks = map_cracks(state.network, state.mesh());
  const double length = total_length(state.network);
  const double spacing = length > 0 ? 2 * mesh.total_area() / length : 0;
  const Chips chips = place_chips(cracks, half_widths(cracks, post.gap, post.late_width),
                                  chip_options(post, spacing, seed));
  warnings.insert(warnings.end(), chips.warnings.begin(), chips.warnings.end());
  return chipped_mesh(std::move(mesh), cracks, chips, context);
}

OpenedMesh unopened(const SurfaceMesh& cut) {
  OpenedMesh opened;
  opened.vertex_of.resize(cut.positions.size());
  opened.face_of.resize(cut.triangles.size());
  std::iota(opened.vertex_of.begin(), opened.vertex_of.end(), 0);
  std::iota(opened.face_of.begin(), opened.face_of.end(), 0);
  opened.beside = opened.face_of;
  return opened;
}

/// Leaves the faces and vertices of `mesh`, which come first.
void drop_walls(const TriangleMesh& mesh, OpenedMesh& opened) {
  const std::size_t vertices = mesh.positions().size(), faces = mesh.triangles().size();
  opened.mesh.positions.resize(vertices);
  opened.vertex_of.resize(vertices);
  opened.mesh.triangles.resize(faces);
  opened.mesh.face_materials.resize(faces);
  opened.face_of.resize(faces);
  opened.beside.resize(faces);
}

/// Faces of chips are flat: broken, not worn.
void flatten_chips(const std::vector<Vec3>& positions, const std::vector<double>& depth,
                   SurfaceMesh& cut) {
  if (depth.empty()) return;
  for (std::size_t f = 0; f < cut.triangles.size(); ++f) {
    const auto& [a, b, c] = cut.triangles[f];
    if (!(std::max({depth[a], depth[b], depth[c]}) > 0)) continue;
    const Vec3 normal = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (normal.squaredNorm() > 0) cut.corner_normals[3 * f + k] = normal.stableNormalized();
    }
  }
}

/// How deep walls are that are there to find crossings alone; chips do not go below them.
double probe(const TriangleMesh& mesh, double thickness, const std::vector<double>& chip_depth) {
  double depth = probe_depth * bounding_diagonal(mesh.positions());
  for (const double chip : chip_depth) depth = std::max(depth, chip / chips_of_wall);
  return std::min(depth, thickness);
}

/// post.face_roughness, of walls that are there.
std::vector<std::string> roughen_faces(const CrackedSurface& state, const TriangleMesh& mesh,
                                       PostParameters post, std::uint64_t seed, OpenedMesh& opened,
                                       const Context& context) {
  const bool is_there = post.wall > 0 || post.thickness > 0;
  if (!(post.face_roughness > 0) || !is_there || state.network.edges.empty()) return {};
  resolve_roughness(post, state.network);
  if (!(post.roughness > 0)) {
    return {
        "broken faces are flat: post.face_roughness is a share of the roughness of lines, "
        "which is 0 (post.roughness, post.relative_roughness)"};
  }
  const double usual = usual_length(crack_chains(state.network));
  const FaceOptions options{post.face_roughness * std::min<double>(post.roughness, usual), usual,
                            post.roughness_exponent, post.roughness_step, seed};
  return make_faces_rough(mesh, crack_sites(mesh), options, opened, context);
}

/// Nothing is lifted or goes down farther than the surface is large: more shows nothing more. Of
/// openings that leave nothing of the pieces the limit (opening_limit.h) says so.
void bound_opening(const TriangleMesh& mesh, const std::vector<Vec3>& displacement,
                   OpeningOptions& options, std::vector<std::string>& warnings) {
  constexpr double widest = 1e6;  // in diagonals
  const double most = bounding_diagonal(mesh.positions());
  double farthest = 0;
  for (const Vec3& u : displacement) farthest = std::max(farthest, u.norm());
  const auto bound = [&](double& value, double of_one, const char* key) {
    if (!(std::isfinite(value) && std::abs(value) * of_one > most)) return;
    value = std::copysign(most / of_one, value);
    warnings.push_back(fmt::format(
        "{} asks for more than the surface is large, {:.3g}: {:.3g} is taken", key, most, value));
  };
  if (std::isfinite(options.gap) && options.gap * farthest > widest * most) {
    options.gap = widest * most / farthest;
  }
  bound(options.curl, std::min(options.gap * farthest, most), "post.curl");
  bound(options.wall, 1, "post.wall");
}

std::vector<std::string> opening_warnings(const OpenedMesh& opened, const TriangleMesh& mesh) {
  std::vector<std::string> warnings;
  if (opened.limited_vertices > 0) {
    warnings.push_back(fmt::format(
        "post.gap, post.wall and post.curl are more than the surface has room for: at {} of {} "
        "vertices it opens less, down to {:.2g} of what was asked, so that it does not pass "
        "through itself",
        opened.limited_vertices, mesh.vertex_count(), opened.least_share));
  }
  if (opened.crossings > 0 || opened.folded_faces > 0) {
    warnings.push_back(
        fmt::format("the opened surface still passes through itself: {} pairs of triangles cross, "
                    "{} are turned "
                    "over; try a smaller post.gap, post.wall or post.curl",
                    opened.crossings, opened.folded_faces));
  }
  return warnings;
}

}  // namespace

const TriangleMesh& OpenedSurface::base(const Result& result) const {
  return refined ? *refined : result.state().mesh();
}

OpenedSurface opened_surface(const Result& result, SurfaceMesh cut, GrowthTimes times,
                             const PostParameters& post, const Context& context) {
  if (const double thickness = post.thickness; !(std::isfinite(thickness) && thickness >= 0)) {
    throw Error(ErrorKind::request, "cannot open the cracks", "thickness",
                "must be finite and not negative");
  }
  OpenedSurface surface;
  surface.times = std::move(times);
  surface.warnings = warnings_of_idle_keys(post, !result.state().network.edges.empty());
  if (post.gap == 0 && post.wall == 0 && post.thickness == 0) {
    surface.opened = unopened(cut);
    surface.mesh = std::move(cut);
    return surface;
  }
  const CrackedSurface& state = result.state();
  std::vector<Vec3> displacement = state.displacements();
  if (post.curl != 0 && state.asset) {
    const double length = natural_curl_length(state.mesh(), surface.times.sites);
    surface.refined = refined_to_bend(
        state.mesh(), find_attribute(cut.vertex_attributes, "crack_distance")->values, length);
  }
  OpeningOptions options;
  if (post.chipping > 0 && post.gap > 0) {
    ChippedMesh made = chipped(state, surface.refined.get(), post,
                               result.report().recipe.simulation.seed, surface.warnings, context);
    surface.refined = std::move(made.mesh);
    options.chip_depth = std::move(made.depth);
  }
  const TriangleMesh& mesh = surface.base(result);
  if (surface.refined) {
    cut.vertex_attributes.push_back(as_attribute(displacement));
    cut = transfer_attributes(cut, mesh, context.threads);
    displacement = as_vectors(cut.vertex_attributes.back());
    cut.vertex_attributes.pop_back();
    surface.times = growth_times(mesh, state.network);
  }
  if (post.late_width != 1 && post.gap > 0) {
    displacement = aged_displacement(mesh, surface.times.sites, displacement, state.crack_times(),
                                     width_by_age(post.late_width, state.network.edges));
  }
  options.gap = post.gap;
  options.wall = post.wall;
  if (post.thickness > 0) {
    // Shallow ones, which tell where rims in one plane would slide over each other.
    options.wall = post.gap > 0 ? probe(mesh, post.thickness, options.chip_depth) : 0;
  }
  options.curl = post.curl;
  bound_opening(mesh, displacement, options, surface.warnings);
  surface.opened = open_cracks(mesh, displacement, options, context);
  for (std::string& warning : opening_warnings(surface.opened, mesh)) {
    surface.warnings.push_back(std::move(warning));
  }
  if (post.thickness > 0) {
    drop_walls(mesh, surface.opened);
    const std::vector<std::string> warnings =
        make_solid(mesh, crack_sites(mesh), outwards(state, surface.refined.get(), context.threads),
                   {post.thickness, post.wedge, post.core}, surface.opened, context);
    surface.warnings.insert(surface.warnings.end(), warnings.begin(), warnings.end());
  }
  for (std::string& warning : roughen_faces(
           state, mesh, post, result.report().recipe.simulation.seed, surface.opened, context)) {
    surface.warnings.push_back(std::move(warning));
  }
  context.check();
  surface.shut = post.gap == 0;
  surface.curled = (post.curl != 0 || post.chipping > 0) && !surface.shut;
  if (surface.curled && !cut.corner_normals.empty()) {
    cut.corner_normals = turned_normals(cut, surface.opened.mesh.positions);
    flatten_chips(surface.opened.mesh.positions, options.chip_depth, cut);
  }
  surface.mesh = opened_attributes(cut, mesh, surface.opened);
  return surface;
}

}  // namespace craze
