#include "craze/engine/asset/cut_asset.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "craze/engine/asset/asset_topology.h"
#include "craze/engine/asset/curve_sites.h"
#include "craze/engine/asset/lone_lines.h"
#include "craze/engine/asset/part_sides.h"
#include "craze/engine/asset/refine_asset.h"
#include "craze/engine/asset/spurs.h"
#include "craze/error.h"

namespace craze {

namespace {

constexpr std::size_t edges_between_looks = 1024;

void check(const SurfaceMesh& asset, const CrackCurves& curves) {
  for (std::size_t p = 0; p < curves.points.size(); ++p) {
    const SurfacePoint& at = curves.points[p];
    if (at.face < 0 || at.face >= static_cast<std::int32_t>(asset.triangles.size()) ||
        !at.weights.allFinite()) {
      throw Error(ErrorKind::request, "bad curve", "point " + std::to_string(p),
                  "it lies on no face of the asset");
    }
  }
  const auto points = static_cast<std::int32_t>(curves.points.size());
  for (std::size_t e = 0; e < curves.edges.size(); ++e) {
    for (const std::int32_t p : curves.edges[e]) {
      if (p >= 0 && p < points) continue;
      throw Error(ErrorKind::request, "bad curve", "edge " + std::to_string(e),
                  "it ends at no point");
    }
  }
}

double mean_chord(const CrackCurves& curves, const std::vector<std::int32_t>& points,
                  const SiteTable& sites, const std::vector<Vec3>& places) {
  double sum = 0;
  for (const auto& [a, b] : curves.edges) {
    const Vec3 chord = sites.position(points[a], places) - sites.position(points[b], places);
    sum += sites.period().shortest(chord).norm();
  }
  return curves.edges.empty() ? 0 : sum / static_cast<double>(curves.edges.size());
}

/// `positions`: those of cut on the surface where the curves are straight.
void find_edges(CutAsset& cut, const CrackCurves& curves, const std::vector<Vec3>& positions,
                const Period& period, const std::vector<CurveLine>& lines, const LineSides& sides) {
  // How far along the curve edge's chord a vertex lies.
  const auto along = [&](const std::array<std::int32_t, 2>& ends, std::int32_t v) {
    const Vec3& a = positions[cut.point_vertex[ends[0]]];
    const Vec3& b = positions[cut.point_vertex[ends[1]]];
    return period.shortest(positions[v] - a).dot(period.shortest(b - a));
  };
  std::vector<double> start(lines.size());  // of each edge, along its curve edge
  for (std::size_t k = 0; k < lines.size(); ++k) {
    CutEdge edge{lines[k].curve_edge, {-1, -1}};
    for (std::int32_t s = sides.first[k]; s < sides.first[k + 1]; ++s) {
      const std::int32_t h = sides.halfedges[s];
      const Triangle& t = cut.triangles[h / 3];
      const auto& ends = curves.edges[edge.curve_edge];
      const bool forward = along(ends, t[(h + 1) % 3]) > along(ends, t[h % 3]);
      std::int32_t& own = edge.side[forward ? 0 : 1];
      std::int32_t& other = edge.side[forward ? 1 : 0];
      (own < 0 ? own : other) = h;
      start[k] = along(ends, t[(forward ? h : h + 1) % 3]);
    }
    cut.edges.push_back(edge);
  }
  std::vector<std::size_t> order(cut.edges.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(cut.edges[a].curve_edge, start[a]) <
           std::tie(cut.edges[b].curve_edge, start[b]);
  });
  std::vector<CutEdge> sorted;
  for (const std::size_t e : order) sorted.push_back(cut.edges[e]);
  cut.edges = std::move(sorted);
}

}  // namespace

CutAsset cut_asset(const SurfaceMesh& asset, const AssetTopology& topology,
                   const CrackCurves& curves, const CutOptions& options, const Context& context) {
  check(asset, curves);
  SiteTable sites(asset, topology, options.snap, options.period);
  std::vector<std::int32_t> points;
  for (const SurfacePoint& p : curves.points) points.push_back(sites.at(p));
  const SurfaceMesh& straight = options.straight_on ? *options.straight_on : asset;
  CurveTracer tracer(straight, topology, sites,
                     mean_chord(curves, points, sites, straight.positions));
  std::vector<CurvePiece> pieces;
  for (std::size_t e = 0; e < curves.edges.size(); ++e) {
    if (e % edges_between_looks == 0) context.check();
    tracer.trace(points[curves.edges[e][0]], points[curves.edges[e][1]],
                 static_cast<std::int32_t>(e), pieces);
  }
  context.check();
  RefinedAsset refined = refine_asset(asset, topology, sites, pieces, points, options.snap);
  drop_spurs(pieces, refined);
  halve_lone_lines(topology, sites, refined);
  context.check();
  const LineSides sides = part_sides(asset, topology, sites, refined);

  CutAsset cut;
  std::vector<std::int32_t> vertex(sites.count(), -1);  // of each site
  for (std::size_t p = 0; p < refined.parts.size(); ++p) {
    const std::int32_t f = refined.parts[p];
    for (int i = 0; i < 3; ++i) {
      const std::int32_t site = refined.part_sites[3 * p + i];
      cut.part_weights.push_back(weights_of(sites.in_face(site, refined.face_source[f])));
      if (vertex[site] < 0) vertex[site] = refined.triangles[f][i];
    }
  }
  for (const std::int32_t s : points) {
    const std::int32_t site = refined.same_site[s];
    const bool is_corner = sites[site].kind == SiteKind::place;
    cut.point_vertex.push_back(is_corner ? sites[site].where : vertex[site]);
  }
  cut.report.split_faces = static_cast<std::int32_t>(
      std::lower_bound(refined.parts.begin(), refined.parts.end(),
                       static_cast<std::int32_t>(asset.triangles.size())) -
      refined.parts.begin());
  cut.report.traced = tracer.report();
  cut.report.lost_segments = refined.lost_segments;
  cut.root.resize(refined.positions.size() - refined.root.size());
  std::iota(cut.root.begin(), cut.root.end(), 0);
  cut.root.insert(cut.root.end(), refined.root.begin(), refined.root.end());
  cut.positions = std::move(refined.positions);
  cut.triangles = std::move(refined.triangles);
  cut.new_vertices = std::move(refined.new_vertices);
  cut.face_source = std::move(refined.face_source);
  cut.parts = std::move(refined.parts);
  find_edges(
      cut, curves,
      options.period.is_given() ? cut.positions : positions_on(cut, asset, straight.positions),
      options.period, refined.lines, sides);
  return cut;
}

std::vector<Vec3> positions_on(const CutAsset& cut, const SurfaceMesh& asset,
                               const std::vector<Vec3>& places) {
  std::vector<Vec3> positions = places;
  for (const SurfacePoint& at : cut.new_vertices) {
    const Triangle& t = asset.triangles[at.face];
    positions.push_back(at.weights[0] * places[t[0]] + at.weights[1] * places[t[1]] +
                        at.weights[2] * places[t[2]]);
  }
  return positions;
}

}  // namespace craze
