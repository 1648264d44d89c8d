#include "craze/products/solids/solids.h"

#include <fmt/format.h>

#include <algorithm>

#include "craze/mesh/bounding_diagonal.h"
#include "craze/products/solids/shells.h"
#include "craze/products/solids/solid_depth.h"
#include "craze/products/solids/solid_shape.h"
#include "craze/products/solids/solid_topology.h"

namespace craze {

namespace {

void append(const SolidTopology& topology, std::vector<Vec3> positions, OpenedMesh& opened) {
  const auto faces = static_cast<std::int32_t>(opened.mesh.triangles.size());
  const auto vertices = static_cast<std::int32_t>(opened.mesh.positions.size());
  opened.solid = SolidParts{faces + topology.inner_begin, faces + topology.core_begin,
                            vertices + topology.core_bottom, topology.core};
  SurfaceMesh& mesh = opened.mesh;
  mesh.positions = std::move(positions);
  mesh.triangles.insert(mesh.triangles.end(), topology.triangles.begin(), topology.triangles.end());
  mesh.material_names = {"crack_wall"};
  mesh.face_materials.resize(static_cast<std::size_t>(faces), -1);
  mesh.face_materials.resize(mesh.triangles.size(), 0);
  for (const SolidBottom& bottom : topology.bottoms) opened.vertex_of.push_back(bottom.vertex);
  opened.face_of.resize(mesh.triangles.size(), -1);
  opened.beside.insert(opened.beside.end(), topology.beside.begin(), topology.beside.end());
}

std::vector<std::string> warnings_of(const SolidDepth& limit, const SolidTopology& topology,
                                     const SolidOptions& options) {
  std::vector<std::string> warnings;
  if (limit.limited > 0) {
    warnings.push_back(fmt::format(
        "post.thickness is more than there is room for: at {} of {} vertices pieces are less "
        "thick, down to {:.2g} of what was asked, so that they do not pass through themselves or "
        "each other",
        limit.limited, limit.depth.size(), limit.least));
  }
  if (limit.crossings > 0) {
    warnings.push_back(
        fmt::format("pieces still pass through themselves or each other: {} pairs of triangles "
                    "cross or are turned over; try a smaller post.thickness",
                    limit.crossings));
  }
  if (options.core && topology.core.empty()) {
    warnings.push_back("there is no core (post.core): the surface is not closed");
  }
  return warnings;
}

}  // namespace

std::vector<std::string> make_solid(const TriangleMesh& mesh, const CrackSites& sites,
                                    std::vector<Vec3> outwards, const SolidOptions& options,
                                    OpenedMesh& opened, const Context& context) {
  for (std::size_t v = 0; v < outwards.size(); ++v) {
    if (sites.site_of[v] >= 0) outwards[v] = outwards[sites.vertex[sites.site_of[v]]];
  }
  const Shells shells = find_shells(mesh, sites);
  const SolidTopology topology = solid_topology(mesh, sites, options.core ? &shells : nullptr);
  const std::vector<double> clearance = largest_moves(mesh, sites, opened.mesh.positions);
  // Beyond the object's own size more thickness shows nothing more.
  const double thickness = std::min(options.thickness, bounding_diagonal(mesh.positions()));
  const SolidShape shape{
      mesh,    sites, shells, opened.mesh.positions, outwards, clearance, options.wedge / thickness,
      topology};
  const SolidDepth limit = limit_depth(shape, thickness, context);
  append(topology, shape.positions(limit.depth), opened);
  return warnings_of(limit, topology, options);
}

}  // namespace craze
