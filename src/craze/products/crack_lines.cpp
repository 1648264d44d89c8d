#include "craze/products.h"

#include "craze/base/progress_meter.h"
#include "craze/engine/cracked_surface.h"
#include "craze/mesh/uv_islands.h"

namespace craze {

namespace {

/// Where the cracks lie in the texture: on the cut mesh, whose vertices may have slid off the
/// triangles that they began on.
class CrackUvs {
 public:
  explicit CrackUvs(const CrackedSurface& state)
      : state_(state), mesh_(state.mesh()), island_(uv_islands(*state.surface)) {
    SurfaceMesh uvs_alone;
    uvs_alone.positions = state.surface->positions;
    uvs_alone.triangles = state.surface->triangles;
    uvs_alone.corner_uvs = state.surface->corner_uvs;
    uvs_ = state.with_attributes(uvs_alone).corner_uvs;
  }

  /// Seen from the face of a side, so that an end on a seam is in the edge's own island.
  Vec2 at(std::int32_t side, const CrackNode& node) const {
    const std::int32_t next = TriangleMesh::next(side);
    for (const std::int32_t corner : {side, next}) {
      if (mesh_.root(mesh_.from(corner)) == node.vertex) return uvs_[corner];
    }
    const Vec3& a = mesh_.position(mesh_.from(side));
    const Vec3 d = mesh_.position(mesh_.to(side)) - a;
    const double t = (node.position - a).dot(d) / d.squaredNorm();
    return (1 - t) * uvs_[side] + t * uvs_[next];
  }
  std::int32_t island(std::int32_t side) const {
    const std::int32_t f = TriangleMesh::face_of(side);
    return island_[state_.asset ? state_.asset->cut.face_source[f] : mesh_.source_face(f)];
  }

 private:
  const CrackedSurface& state_;
  const TriangleMesh& mesh_;
  std::vector<std::int32_t> island_;  // #F of the surface
  std::vector<Vec2> uvs_;             // 3 #F of the cut mesh
};

void add_uvs(LineSet& lines, const CrackedSurface& state) {
  const CrackUvs uvs(state);
  Attribute island{"uv_island", 1, {}};
  for (const CrackEdge& edge : state.network.edges) {
    for (const std::int32_t end : {edge.a, edge.b}) {
      lines.uvs.push_back(uvs.at(edge.side, state.network.nodes[end]));
    }
    island.values.push_back(uvs.island(edge.side));
  }
  lines.edge_attributes.push_back(std::move(island));
}

}  // namespace

LineSet crack_lines(const Result& result, const Context& context) {
  const CrackedSurface& state = result.state();
  const CrackNetwork& network = state.network;
  LineSet lines;
  ProgressMeter meter(context, "lines", network.nodes.size() + network.edges.size());
  Attribute junction{"junction", 1, {}}, normal{"normal", 3, {}};
  for (const CrackNode& node : network.nodes) {
    meter.at(lines.points.size());
    lines.points.push_back(node.position);
    junction.values.push_back(static_cast<double>(node.kind));
    normal.values.insert(normal.values.end(), node.normal.data(), node.normal.data() + 3);
  }
  Attribute time{"time", 1, {}}, width{"width", 1, {}}, event{"event", 1, {}};
  for (const CrackEdge& edge : network.edges) {
    meter.at(lines.points.size() + lines.edges.size());
    lines.edges.push_back({edge.a, edge.b});
    time.values.push_back(edge.time);
    width.values.push_back(edge.width);
    event.values.push_back(static_cast<double>(edge.event));
  }
  meter.finish();
  lines.point_attributes = {std::move(junction), std::move(normal)};
  lines.edge_attributes = {std::move(time), std::move(width), std::move(event)};
  if (!state.surface->corner_uvs.empty()) add_uvs(lines, state);
  return lines;
}

}  // namespace craze
