#include <algorithm>
#include <map>
#include <numeric>

#include "craze/products/distance/crack_seams.h"
#include "craze/products/statistics/graph/graph_input.h"
#include "craze/products/statistics/graph/point_index.h"
#include "craze/repair.h"

namespace craze {
namespace {

/// Triangles that share an edge, by union–find.
class Pieces {
 public:
  explicit Pieces(std::size_t faces) : parent_(faces) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::int32_t find(std::int32_t f) {
    while (parent_[f] != f) f = parent_[f] = parent_[parent_[f]];
    return f;
  }
  void join(std::int32_t f, std::int32_t g) {
    f = find(f);
    g = find(g);
    parent_[std::max(f, g)] = std::min(f, g);
  }
  /// Piece of each face, counted from 0 in order of their first faces.
  std::vector<std::int32_t> labels() {
    std::vector<std::int32_t> label(parent_.size(), -1);
    std::int32_t count = 0;
    for (std::size_t f = 0; f < parent_.size(); ++f) {
      const std::int32_t root = find(static_cast<std::int32_t>(f));
      if (root == static_cast<std::int32_t>(f)) label[f] = count++;
      label[f] = label[root];
    }
    return label;
  }

 private:
  std::vector<std::int32_t> parent_;
};

/// Areas of the pieces, and the whole.
void add_areas(CrackGraphInput& graph, const std::vector<Vec3>& positions,
               const std::vector<Triangle>& triangles, const std::vector<std::int32_t>& piece) {
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    const Vec3& p = positions[t[0]];
    const double area = (positions[t[1]] - p).cross(positions[t[2]] - p).norm() / 2;
    if (piece[f] >= static_cast<std::int32_t>(graph.piece_areas.size())) {
      graph.piece_areas.resize(piece[f] + 1, 0.0);
    }
    graph.piece_areas[piece[f]] += area;
    graph.surface_area += area;
  }
}

/// Area-weighted normals of the graph's points, which are found by their position.
void add_normals(CrackGraphInput& graph, const PointIndex& index,
                 const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  graph.normals.assign(graph.points.size(), Vec3::Zero());
  for (const Triangle& t : triangles) {
    const Vec3 normal =
        (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
    for (const std::int32_t v : t) {
      const std::int32_t p = index.find(positions[v]);
      if (p >= 0) graph.normals[p] += normal;
    }
  }
  for (Vec3& n : graph.normals) n = n.norm() > 0 ? Vec3(n.normalized()) : Vec3::UnitZ();
}

}  // namespace

CrackGraphInput graph_from_network(const CrackNetwork& network, const TriangleMesh& mesh) {
  CrackGraphInput graph;
  PointIndex index;
  for (const CrackNode& node : network.nodes) index.add(node.position);
  Pieces pieces(mesh.face_count());
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (!mesh.is_open(h)) pieces.join(h / 3, mesh.opposite(h) / 3);
  }
  const std::vector<std::int32_t> piece = pieces.labels();

  // The faces beside each open edge, keyed by its directed end points.
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> left_of;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (!mesh.is_open(h)) continue;
    const std::int32_t a = index.add(mesh.position(mesh.from(h)));
    const std::int32_t b = index.add(mesh.position(mesh.to(h)));
    left_of[{a, b}] = piece[h / 3];
    if (mesh.opposite(h) != TriangleMesh::border) continue;
    GraphInputEdge edge;
    edge.a = a;
    edge.b = b;
    edge.border = true;
    edge.left_piece = piece[h / 3];
    graph.edges.push_back(edge);
  }
  for (const CrackEdge& crack : network.edges) {
    GraphInputEdge edge;
    edge.a = index.find(network.nodes[crack.a].position);
    edge.b = index.find(network.nodes[crack.b].position);
    if (edge.a == edge.b) continue;
    edge.time = crack.time;
    edge.event = crack.event;
    if (const auto l = left_of.find({edge.a, edge.b}); l != left_of.end()) {
      edge.left_piece = l->second;
    }
    if (const auto r = left_of.find({edge.b, edge.a}); r != left_of.end()) {
      edge.right_piece = r->second;
    }
    graph.edges.push_back(edge);
  }
  add_areas(graph, mesh.positions(), mesh.triangles(), piece);
  PointIndex lookup = index;
  graph.points = index.take();
  add_normals(graph, lookup, mesh.positions(), mesh.triangles());
  for (const CrackNode& node : network.nodes) {
    if (node.normal.norm() > 0) graph.normals[lookup.find(node.position)] = node.normal;
  }
  return graph;
}

CrackGraphInput graph_from_cut_mesh(const SurfaceMesh& file, const Context& context) {
  RepairOptions keep_apart;
  keep_apart.tolerance = -1;
  RepairReport report;
  const SurfaceMesh surface = repair(file, keep_apart, report, context);
  const TriangleMesh mesh(surface.positions, surface.triangles);
  const std::vector<KnownSeam> seams = known_seams(surface, mesh);

  Pieces pieces(mesh.face_count());
  std::vector<char> is_seam(3 * static_cast<std::size_t>(mesh.face_count()), 0);
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) != TriangleMesh::border) pieces.join(h / 3, mesh.opposite(h) / 3);
  }
  for (const auto& [seam, kind] : seams) {
    if (kind == SeamKind::border) continue;
    is_seam[seam.side] = is_seam[seam.other] = 1;
    if (kind == SeamKind::joined) pieces.join(seam.side / 3, seam.other / 3);
  }
  const std::vector<std::int32_t> piece = pieces.labels();

  CrackGraphInput graph;
  graph.metres_per_unit = file.metres_per_unit;
  const Attribute* time = find_attribute(surface.vertex_attributes, "crack_time");
  PointIndex index;
  const auto add_edge = [&](std::int32_t from, std::int32_t to,
                            std::int32_t side) -> GraphInputEdge& {
    GraphInputEdge& edge = graph.edges.emplace_back();
    edge.a = index.add(mesh.position(from));
    edge.b = index.add(mesh.position(to));
    edge.left_piece = piece[side / 3];
    return edge;
  };
  for (const auto& [seam, kind] : seams) {
    if (kind != SeamKind::crack) continue;
    GraphInputEdge& edge = add_edge(seam.from, seam.to, seam.side);
    edge.right_piece = piece[seam.other / 3];
    if (time) edge.time = std::max(time->values[seam.from], time->values[seam.to]);
  }
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) != TriangleMesh::border || is_seam[h]) continue;
    add_edge(mesh.from(h), mesh.to(h), h).border = true;
  }
  add_areas(graph, mesh.positions(), mesh.triangles(), piece);
  PointIndex lookup = index;
  graph.points = index.take();
  add_normals(graph, lookup, mesh.positions(), mesh.triangles());
  return graph;
}

}  // namespace craze
