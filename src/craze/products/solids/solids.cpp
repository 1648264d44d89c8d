#include "craze/products/solids/solids.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "craze/base/text/format.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/products/opening/spread_limit.h"
#include "craze/products/solids/shells.h"
#include "craze/products/solids/solid_depth.h"
#include "craze/products/solids/solid_shape.h"
#include "craze/products/solids/solid_topology.h"

namespace craze {

namespace {

constexpr int most_closings = 8;

/// Takes cracks back to where they were shut, there and less and less around.
class CrackShutter {
 public:
  CrackShutter(const TriangleMesh& mesh, const CrackSites& sites, std::vector<Vec3> opened,
               std::vector<Vec3> chipped)
      : mesh_(mesh),
        sites_(sites),
        opened_(std::move(opened)),
        chipped_(std::move(chipped)),
        on_site_(sites.vertex.size()),
        share_(opened_.size(), 1) {
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (sites.site_of[v] >= 0) on_site_[sites.site_of[v]].push_back(v);
      farthest_ = std::max(farthest_, (opened_[v] - mesh.position(v)).norm());
    }
  }

  /// `where` (#V); sets `positions` (#V).
  /// Likewise `chipped` (#V, or none).
  void shut(const std::vector<std::uint8_t>& where, std::vector<Vec3>& positions,
            std::vector<Vec3>& chipped) {
    constexpr double taper = 3;  // in farthest moves: vertices keep their order along a crack
    for (std::size_t v = 0; v < share_.size(); ++v) {
      if (where[v]) share_[v] = 0;
    }
    spread_limit(mesh_, sites_, on_site_, 1, 1, taper * farthest_, share_);
    for (std::size_t v = 0; v < share_.size(); ++v) {
      const Vec3& at = mesh_.positions()[v];
      positions[v] = share_[v] < 1 ? Vec3(at + share_[v] * (opened_[v] - at)) : opened_[v];
    }
    for (std::size_t v = 0; v < chipped.size(); ++v) chipped[v] = share_[v] * chipped_[v];
  }

  std::int64_t shut_vertices() const {
    return std::count_if(share_.begin(), share_.end(), [](double s) { return s < 1; });
  }

 private:
  const TriangleMesh& mesh_;
  const CrackSites& sites_;
  std::vector<Vec3> opened_, chipped_;
  std::vector<std::vector<std::int32_t>> on_site_;
  std::vector<double> share_;  // #V, of the way from shut to open
  double farthest_ = 0;
};

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

std::vector<std::string> warnings_of(const SolidDepth& limit, std::int64_t shut,
                                     const SolidTopology& topology, const SolidOptions& options) {
  std::vector<std::string> warnings;
  if (shut > 0) {
    warnings.push_back(fmt::format(
        "pieces would pass through each other however thin (post.gap): at {} of {} vertices their "
        "cracks open less, or not at all",
        shut, limit.depth.size()));
  }
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
  // Beyond the object's own size more thickness shows nothing more.
  const double thickness = std::min(options.thickness, bounding_diagonal(mesh.positions()));
  std::vector<double> clearance = largest_moves(mesh, sites, opened.mesh.positions);
  const SolidShape shape{mesh,
                         sites,
                         shells,
                         opened.mesh.positions,
                         outwards,
                         clearance,
                         options.wedge / thickness,
                         topology,
                         opened.chipped};
  SolidDepth limit = limit_depth(shape, thickness, context);
  CrackShutter shutter(mesh, sites, opened.mesh.positions, opened.chipped);
  for (int round = 0; limit.crossings > 0 && round < most_closings; ++round) {
    shutter.shut(limit.stuck, opened.mesh.positions, opened.chipped);
    clearance = largest_moves(mesh, sites, opened.mesh.positions);
    limit = limit_depth(shape, thickness, context);
  }
  append(topology, shape.positions(limit.depth), opened);
  return warnings_of(limit, shutter.shut_vertices(), topology, options);
}

}  // namespace craze
