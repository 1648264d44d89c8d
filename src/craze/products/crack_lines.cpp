#include "craze/products/crack_lines.h"

#include "craze/base/progress_meter.h"
#include "craze/engine/cracked_surface.h"
#include "craze/mesh/transfer_attributes.h"

namespace craze {

namespace {

Vec2 uv_at(const SurfaceMesh& surface, std::int32_t f, const Vec3& p) {
  const TrianglePoint at = locate_in_triangle(surface, f, p);
  Vec2 uv = Vec2::Zero();
  for (int i = 0; i < 3; ++i) {
    uv += at.weights[i] * surface.corner_uvs[3 * static_cast<std::size_t>(f) + at.corners[i]];
  }
  return uv;
}

}  // namespace

LineSet crack_lines(const Result& result, const Context& context) {
  const CrackNetwork& network = result.state().network;
  const SurfaceMesh& surface = result.state().surface;
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
    if (surface.corner_uvs.empty()) continue;
    for (const std::int32_t end : {edge.a, edge.b}) {
      lines.uvs.push_back(uv_at(surface, edge.face, network.nodes[end].position));
    }
  }
  lines.point_attributes = {std::move(junction), std::move(normal)};
  lines.edge_attributes = {std::move(time), std::move(width), std::move(event)};
  return lines;
}

}  // namespace craze
