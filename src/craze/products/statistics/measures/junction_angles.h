// The angles at which cracks meet.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/products/statistics/graph/crack_graph.h"

namespace craze {

/// Where along a branch its direction is measured, as arc length from the node in model units.
struct BranchFit {
  double from = 0;  ///< r₁: what is nearer is blurred by the junction itself
  double to = 0;    ///< r₂
};

/// Direction of the line fitted (PCA) to the polyline over arc length [r₁, r₂] from its first
/// point, radians in `frame`. Points are taken to the tangent plane of the first point by an
/// approximate logarithmic map: the direction of their projection at the length of their chord. A
/// shorter polyline is fitted over what it has.
double branch_direction(const std::vector<Vec3>& points, const Vec3& normal, const Mat32& frame,
                        const BranchFit& fit);

/// The angles between neighbouring branches around a node, radians, summing to 2π: sectors[i] lies
/// between darts[i] and darts[i+1], on the left of darts[i].
std::vector<double> sector_angles(const CrackGraph& graph, std::int32_t node, const BranchFit& fit);

/// Of all nodes: element n belongs to graph.nodes()[n].
std::vector<std::vector<double>> all_sector_angles(const CrackGraph& graph, const BranchFit& fit);

enum class JunctionShape { t, y, mixed };

/// A junction of three: T if the largest angle is within `tolerance` of π, Y if all are within it
/// of 2π/3.
JunctionShape junction_shape(const std::vector<double>& sectors, double tolerance);

/// A T's darts: the leg, and the two that together are the crossbar.
struct TParts {
  Dart leg, crossbar[2];
};
TParts t_parts(const CrackGraph::Node& node, const std::vector<double>& sectors);

}  // namespace craze
