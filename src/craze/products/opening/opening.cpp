#include "craze/products/opening/opening.h"

#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "craze/error.h"
#include "craze/products/opening/curl.h"
#include "craze/products/opening/opening_limit.h"
#include "craze/products/opening/side_walls.h"
#include "craze/products/opening/turned_faces.h"
#include "craze/products/opening/vertex_normals.h"

namespace craze {

namespace {

void check(const TriangleMesh& mesh, const std::vector<Vec3>& displacement,
           const OpeningOptions& options) {
  const auto require = [](bool good, const char* where, const char* why) {
    if (!good) throw Error(ErrorKind::request, "cannot open the cracks", where, why);
  };
  require(displacement.size() == mesh.positions().size(), "displacement",
          "there must be one vector per vertex");
  const auto is_length = [](double x) { return std::isfinite(x) && x >= 0; };
  require(is_length(options.gap), "gap", "must be finite and not negative");
  require(is_length(options.wall), "wall", "must be finite and not negative");
  require(std::isfinite(options.curl), "curl", "must be finite");
  require(options.chip_depth.empty() || options.chip_depth.size() == displacement.size(),
          "chip_depth", "there must be one per vertex, or none");
  require(is_length(options.curl_length), "curl_length", "must be finite and not negative");
}

/// [IO06 Eq. 9] γ times the accumulated displacement.
std::vector<Vec3> shifts(const TriangleMesh& mesh, const CrackSites& sites,
                         const std::vector<Vec3>& displacement, const OpeningOptions& options) {
  std::vector<Vec3> shift(displacement.size());
  for (std::size_t v = 0; v < shift.size(); ++v) shift[v] = options.gap * displacement[v];
  if (!options.keep_border) return shift;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) != TriangleMesh::border) continue;
    for (const std::int32_t v : {mesh.from(h), mesh.to(h)}) {
      if (sites.site_of[v] < 0) shift[v] = Vec3::Zero();
    }
  }
  return shift;
}

void add_curl(const TriangleMesh& mesh, const CrackSites& sites, const std::vector<Vec3>& normals,
              const OpeningOptions& options, std::vector<Vec3>& shift) {
  std::vector<double> edge_lift(shift.size());
  for (std::size_t v = 0; v < shift.size(); ++v) edge_lift[v] = options.curl * shift[v].norm();
  const double length =
      options.curl_length > 0 ? options.curl_length : natural_curl_length(mesh, sites);
  const std::vector<double> lift = curl_lift(mesh, sites, edge_lift, length);
  for (std::size_t v = 0; v < shift.size(); ++v) shift[v] += lift[v] * normals[v];
}

/// #V: how far chips move the surface.
std::vector<Vec3> chip_shifts(const std::vector<Vec3>& normals, const std::vector<double>& depth) {
  std::vector<Vec3> shift;
  for (std::size_t v = 0; v < depth.size(); ++v) shift.push_back(-depth[v] * normals[v]);
  return shift;
}

/// Needles that chips would turn over go as deep as one; `chipped` becomes what was added.
void add_chips(const TriangleMesh& mesh, const OpeningOptions& options, std::vector<Vec3>& chipped,
               std::vector<Vec3>& shift) {
  if (!options.keep_border) chipped = needles_moved_as_one(mesh, std::move(chipped), shift);
  for (std::size_t v = 0; v < chipped.size(); ++v) shift[v] += chipped[v];
}

void add_walls(const SideWalls& walls, OpenedMesh& opened) {
  SurfaceMesh& mesh = opened.mesh;
  mesh.triangles.insert(mesh.triangles.end(), walls.triangles.begin(), walls.triangles.end());
  mesh.face_materials.resize(mesh.triangles.size(), 0);
  opened.vertex_of.insert(opened.vertex_of.end(), walls.vertex.begin(), walls.vertex.end());
  opened.face_of.resize(mesh.triangles.size(), -1);
  opened.beside.insert(opened.beside.end(), walls.beside.begin(), walls.beside.end());
}

}  // namespace

OpenedMesh open_cracks(const TriangleMesh& mesh, const std::vector<Vec3>& displacement,
                       const OpeningOptions& options, const Context& context) {
  check(mesh, displacement, options);
  const CrackSites sites = crack_sites(mesh);
  const std::vector<Vec3> normals = vertex_normals(mesh, sites);
  std::vector<Vec3> shift = shifts(mesh, sites, displacement, options);
  if (options.curl != 0) add_curl(mesh, sites, normals, options, shift);
  if (!options.keep_border) shift = needles_moved_as_one(mesh, std::move(shift));

  std::vector<Vec3> chipped = chip_shifts(normals, options.chip_depth);
  if (!chipped.empty()) add_chips(mesh, options, chipped, shift);

  SideWalls walls;
  if (options.wall > 0) {
    walls = side_walls(mesh, sites, normals, options.wall, options.border_wall);
  }
  context.check();
  const OpeningMotion motion{mesh, sites, walls, shift};
  const OpeningLimit limit = limit_opening(motion, context);

  OpenedMesh opened;
  opened.limited_vertices = limit.limited;
  opened.least_share = limit.least;
  opened.folded_faces = limit.folded;
  opened.crossings = limit.crossings;
  opened.mesh.positions = motion.positions(limit.shares);
  for (std::size_t v = 0; v < chipped.size(); ++v) chipped[v] *= limit.shares.move[v];
  opened.chipped = std::move(chipped);
  opened.mesh.triangles = mesh.triangles();
  opened.mesh.material_names = {"crack_wall"};
  opened.mesh.face_materials.assign(mesh.triangles().size(), -1);
  opened.vertex_of.resize(mesh.positions().size());
  opened.face_of.resize(mesh.triangles().size());
  std::iota(opened.vertex_of.begin(), opened.vertex_of.end(), 0);
  std::iota(opened.face_of.begin(), opened.face_of.end(), 0);
  opened.beside = opened.face_of;
  add_walls(walls, opened);
  return opened;
}

}  // namespace craze
