#include "craze/engine/asset/carry_onto_asset.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "craze/engine/asset/carry_field.h"
#include "craze/engine/asset/crack_sides.h"
#include "craze/engine/asset/sheet_search.h"

namespace craze {

namespace {

constexpr double snap_share = 0.05;  // of a crack edge: what no eye sees move

double mean_length(const CrackNetwork& network) {
  double sum = 0;
  for (const CrackEdge& e : network.edges) {
    sum += network.length(e);
  }
  return network.edges.empty() ? 0 : sum / static_cast<double>(network.edges.size());
}

/// Numbers the vertices of `cut` as `mesh` does, which has the same faces. The asset's own, which
/// come first, keep their place, but of the sides of a crack another one may keep the vertex.
void number_as(const TriangleMesh& mesh, CutAsset& cut) {
  const std::size_t own = cut.positions.size() - cut.new_vertices.size();
  std::vector<SurfacePoint> at(cut.positions.size());  // by root
  for (std::size_t v = own; v < at.size(); ++v) at[cut.root[v]] = cut.new_vertices[v - own];
  std::vector<std::int32_t> number(cut.positions.size());
  std::iota(number.begin(), number.end(), 0);  // what has no faces keeps its number
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) number[cut.triangles[f][i]] = mesh.triangle(f)[i];
  }
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    cut.root[v] = mesh.root(v);
    if (v >= static_cast<std::int32_t>(own)) cut.new_vertices[v - own] = at[mesh.root(v)];
  }
  for (std::int32_t& v : cut.point_vertex) v = number[v];
  cut.positions = mesh.positions();
  cut.triangles = mesh.triangles();
}

/// The cracks of the mesh, whose edge e lies on edge cut.edges[e].curve_edge of `simulated`.
CrackNetwork network_on(const TriangleMesh& mesh, const CutAsset& cut,
                        const CrackNetwork& simulated) {
  CrackNetwork network;
  network.period = mesh.period();
  std::vector<std::int32_t> node_of_root(mesh.vertex_count(), -1);
  const auto node = [&](std::int32_t v) {
    std::int32_t& n = node_of_root[mesh.root(v)];
    if (n < 0) {
      n = static_cast<std::int32_t>(network.nodes.size());
      network.nodes.push_back(
          {mesh.position(v), Vec3::Zero(), -1, JunctionKind::bend, mesh.root(v)});
    }
    return n;
  };
  for (const CutEdge& piece : cut.edges) {
    const std::int32_t h = piece.side[0];
    CrackEdge edge = simulated.edges[piece.curve_edge];
    edge.a = node(mesh.from(h));
    edge.b = node(mesh.to(h));
    edge.face = cut.face_source[h / 3];
    edge.side = h;
    network.edges.push_back(edge);
  }
  describe_nodes(mesh, network);
  for (CrackNode& n : network.nodes) n.face = cut.face_source[n.face];
  return network;
}

/// A place for each vertex: they are joined as the surface is.
std::vector<std::int32_t> own_places(const SurfaceMesh& asset) {
  std::vector<std::int32_t> places(asset.positions.size());
  std::iota(places.begin(), places.end(), 0);
  return places;
}

/// From the cut the mesh and its network; `drawn` is what was cut.
void make_mesh(const CrackNetwork& drawn, CrackedAsset& result) {
  // What lies on the asset's border was open before.
  std::vector<CutEdge>& edges = result.cut.edges;
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [](const CutEdge& e) { return e.side[0] < 0 || e.side[1] < 0; }),
              edges.end());
  result.mesh = crack_mesh(result.cut, drawn.period);
  result.network = network_on(result.mesh, result.cut, drawn);
}

/// The sides of the pieces of edges.
std::vector<CrackSides> sides_of_pieces(const std::vector<CrackSides>& of_edges,
                                        const std::vector<SmoothPiece>& pieces) {
  std::vector<CrackSides> result;
  result.reserve(pieces.size());
  for (const SmoothPiece& piece : pieces) {
    CrackSides sides = of_edges[piece.edge];
    for (std::array<Vec3, 2>& value : sides.value) {
      const std::array<Vec3, 2> ends = value;
      for (std::size_t end = 0; end < 2; ++end) {
        const double t = piece.shares[end];
        value[end] = (1 - t) * ends[0] + t * ends[1];
      }
    }
    result.push_back(sides);
  }
  return result;
}

}  // namespace

CrackCurves crack_curves(const CrackNetwork& network, const SurfaceMesh& asset,
                         const AssetTopology& topology,
                         const std::vector<std::int32_t>& asset_face) {
  SheetSearch search(asset, topology, network.period);
  CrackCurves curves;
  for (const CrackNode& node : network.nodes) {
    curves.points.push_back(search.find(node.position, asset_face[node.face]));
  }
  for (const CrackEdge& edge : network.edges) curves.edges.push_back({edge.a, edge.b});
  return curves;
}

CrackedAsset carry_onto_plane(const SurfaceMesh& asset, const CrackNetwork& network,
                              const Context& context) {
  const AssetTopology topology(asset.triangles, own_places(asset));
  std::vector<std::int32_t> asset_face(asset.triangles.size());
  std::iota(asset_face.begin(), asset_face.end(), 0);
  CrackedAsset result;
  result.curves = crack_curves(network, asset, topology, asset_face);
  const CutOptions options{snap_share * mean_length(network), nullptr, network.period};
  result.cut = cut_asset(asset, topology, result.curves, options, context);
  make_mesh(network, result);
  return result;
}

CrackedAsset carry_onto_asset(const SurfaceMesh& asset, const SimulatedCracks& cracked, double snap,
                              const Context& context) {
  const auto reached = [&](double fraction) {
    context.check();
    context.report({"carry", fraction, 0, std::ssize(asset.triangles)});
  };
  reached(0);
  const AssetTopology topology(asset.triangles, own_places(asset));
  CrackedAsset result;
  SurfaceMesh without_bumps;
  const bool has_bumps = cracked.smooth && !cracked.smooth->empty();
  if (has_bumps) {
    without_bumps.positions = *cracked.smooth;
    without_bumps.triangles = asset.triangles;
  }
  const SurfaceMesh& smooth = has_bumps ? without_bumps : asset;
  reached(0.2);
  result.curves = crack_curves(cracked.drawn(), smooth, topology, cracked.asset_face);
  reached(0.3);
  const double near = snap < 0 ? snap_share * mean_length(cracked.drawn()) : snap;
  result.cut = cut_asset(asset, topology, result.curves, {near, &smooth, {}}, context);
  reached(0.6);
  make_mesh(cracked.drawn(), result);
  reached(0.8);
  std::vector<CrackSides> sides =
      crack_sides_of(cracked.mesh, cracked.displacement, cracked.network);
  if (cracked.rough) sides = sides_of_pieces(sides, cracked.rough->pieces);
  result.displacement = carry_field(
      result.cut, positions_on(result.cut, asset, smooth.positions), result.curves,
      {cracked.mesh, cracked.displacement, cracked.parts, sides, cracked.rough != nullptr});
  reached(1);
  return result;
}

TriangleMesh crack_mesh(CutAsset& cut, const Period& period) {
  // Copies are numbered last, so without them the vertices keep their numbers.
  std::vector<Vec3> positions;
  for (std::size_t v = 0; v < cut.positions.size() && cut.root[v] == std::int32_t(v); ++v) {
    positions.push_back(cut.positions[v]);
  }
  std::vector<Triangle> triangles = cut.triangles;
  for (Triangle& t : triangles) {
    for (std::int32_t& v : t) v = cut.root[v];
  }
  TriangleMesh mesh(std::move(positions), std::move(triangles), period);
  for (std::size_t e = 0; e < cut.edges.size(); ++e) {
    const std::int32_t h = cut.edges[e].side[0] >= 0 ? cut.edges[e].side[0] : cut.edges[e].side[1];
    if (!mesh.is_open(h)) mesh.cut(h, static_cast<std::int32_t>(e));
  }
  number_as(mesh, cut);
  return mesh;
}

}  // namespace craze
