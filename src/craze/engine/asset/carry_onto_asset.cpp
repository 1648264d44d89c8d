#include "craze/engine/asset/carry_onto_asset.h"

#include <utility>

#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/carry_field.h"
#include "craze/engine/asset/crack_sides.h"
#include "craze/engine/asset/cut_surface.h"
#include "craze/engine/asset/sheet_search.h"

namespace craze {

namespace {

constexpr double snap_share = 0.05;  // of a crack edge: what no eye sees move

double mean_length(const CrackNetwork& network) {
  double sum = 0;
  for (const CrackEdge& e : network.edges) {
    sum += (network.nodes[e.a].position - network.nodes[e.b].position).norm();
  }
  return network.edges.empty() ? 0 : sum / static_cast<double>(network.edges.size());
}

}  // namespace

CrackCurves crack_curves(const CrackNetwork& network, const SurfaceMesh& asset,
                         const std::vector<std::int32_t>& asset_face) {
  const AssetTopology topology(asset.positions, asset.triangles);
  SheetSearch search(asset, topology);
  CrackCurves curves;
  for (const CrackNode& node : network.nodes) {
    curves.points.push_back(search.find(node.position, asset_face[node.face]));
  }
  for (const CrackEdge& edge : network.edges) curves.edges.push_back({edge.a, edge.b});
  return curves;
}

CrackedAsset carry_onto_asset(const SurfaceMesh& asset, const CrackedSurface& cracked,
                              double snap) {
  CrackedAsset result;
  result.curves = crack_curves(cracked.network, asset, cracked.asset_face);
  const double near = snap < 0 ? snap_share * mean_length(cracked.network) : snap;
  result.cut = cut_asset(asset, result.curves, {near});
  result.surface = cut_surface(asset, result.cut);
  const std::vector<CrackSides> sides =
      crack_sides_of(cracked.mesh, cracked.displacement, cracked.network);
  result.displacement = carry_field(result.cut, result.curves,
                                    {cracked.mesh, cracked.displacement, cracked.parts, sides});
  return result;
}

TriangleMesh crack_mesh(const CutAsset& cut, std::vector<std::int32_t>& vertex_of) {
  // Copies are numbered last, so without them the vertices keep their numbers.
  std::vector<Vec3> positions;
  for (std::size_t v = 0; v < cut.positions.size() && cut.root[v] == std::int32_t(v); ++v) {
    positions.push_back(cut.positions[v]);
  }
  std::vector<Triangle> triangles = cut.triangles;
  for (Triangle& t : triangles) {
    for (std::int32_t& v : t) v = cut.root[v];
  }
  TriangleMesh mesh(std::move(positions), std::move(triangles));
  for (std::size_t e = 0; e < cut.edges.size(); ++e) {
    const std::int32_t h = cut.edges[e].side[0] >= 0 ? cut.edges[e].side[0] : cut.edges[e].side[1];
    if (!mesh.is_open(h)) mesh.cut(h, static_cast<std::int32_t>(e));
  }
  vertex_of.assign(mesh.vertex_count(), -1);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) vertex_of[mesh.triangle(f)[i]] = cut.triangles[f][i];
  }
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (vertex_of[v] < 0) vertex_of[v] = v;  // without faces
  }
  return mesh;
}

}  // namespace craze
