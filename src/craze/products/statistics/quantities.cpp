#include "craze/products/statistics/quantities.h"

namespace craze {
namespace {

using S = Statistics;

constexpr Quantity table[] = {
    {"spacing.root_area", "spacing: root of the mean cell area", &S::root_area},
    {"spacing.area_over_perimeter", "spacing: twice area over perimeter", &S::area_over_perimeter},
    {"length_per_area", "crack length per area x root area", &S::length_per_area},
    {"nodes.end", "nodes: free ends", &S::ends},
    {"nodes.three", "nodes: of three (T, Y)", &S::threes},
    {"nodes.cross", "nodes: of four and more (X)", &S::crosses},
    {"nodes.mean_degree", "mean degree of junctions", &S::mean_degree},
    {"angles.min", "smallest angle, degrees", &S::angle_min},
    {"angles.mid", "middle angle, degrees", &S::angle_mid},
    {"angles.max", "largest angle, degrees", &S::angle_max},
    {"angles.sd", "standard deviation of angles, degrees", &S::angle_sd},
    {"angles.t", "T fraction", &S::t_fraction},
    {"angles.y", "Y fraction", &S::y_fraction},
    {"angles.mixed", "neither T nor Y", &S::mixed_fraction},
    {"angles.leg", "T's: smaller angle of the leg, degrees", &S::leg_angle},
    {"angles.leg_sd", "T's: rms of the leg's angle from 90, degrees", &S::leg_sd},
    {"cells.sides", "sides per cell", &S::sides},
    {"cells.corner_degree", "corners per node", &S::corner_degree},
    {"cells.regular", "regular nodes", &S::regular},
    {"cells.sides_from_nodes", "sides per cell, from the nodes", &S::sides_from_nodes},
    {"cells.sides_flat", "sides per cell, curvature removed", &S::sides_flat},
    {"cells.sides_combinatorial", "junctions per cell", &S::sides_combinatorial},
    {"cells.curvature", "curvature per cell, radians", &S::curvature},
    {"areas.mean", "mean cell area", &S::mean_area},
    {"areas.cv", "areas: coefficient of variation", &S::area_cv},
    {"areas.sd_log", "areas: standard deviation of ln A", &S::area_sd_log},
    {"areas.gamma_shape", "areas: shape of the gamma law", &S::gamma_shape},
    {"areas.gamma_over_lognormal", "areas: log-likelihood per cell, gamma less lognormal",
     &S::gamma_over_lognormal},
    {"areas.slivers", "pieces below 2 % of the mean area", &S::slivers},
    {"circularity.mean", "circularity 4 pi A / P^2", &S::circularity},
    {"circularity.sd", "standard deviation of circularity", &S::circularity_sd},
    {"edges.cv", "edge lengths: coefficient of variation", &S::edge_cv},
    {"edges.tortuosity", "tortuosity: length over chord", &S::tortuosity},
    {"anisotropy.strength", "anisotropy", &S::anisotropy},
    {"anisotropy.null", "anisotropy of random directions", &S::anisotropy_null},
    {"anisotropy.entropy", "entropy of directions over ln 18", &S::direction_entropy},
    {"anisotropy.direction", "preferred direction, degrees", &S::direction},
    {"anisotropy.rms", "rms deviation from it, degrees", &S::direction_rms},
    {"order.leg_younger", "T's whose leg is younger", &S::leg_younger},
    {"order.kendall_tau", "Kendall tau of time and geometry", &S::kendall_tau},
    {"flaws.dead_ends", "dead ends, share of length", &S::dead_ends},
    {"flaws.spurs", "spurs, share of length", &S::spurs},
    {"flaws.micro_cracks", "micro-cracks, share of length", &S::micro_cracks},
};

}  // namespace

std::span<const Quantity> quantities() {
  return table;
}

}  // namespace craze
