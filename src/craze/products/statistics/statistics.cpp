#include "craze/products/statistics/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "craze/products/statistics/gamma_fit.h"
#include "craze/products/statistics/measures/anisotropy.h"
#include "craze/products/statistics/measures/cells.h"
#include "craze/products/statistics/measures/crack_order.h"
#include "craze/products/statistics/measures/flaws.h"
#include "craze/products/statistics/measures/junction_angles.h"
#include "craze/products/statistics/measures/pattern.h"

namespace craze {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degrees = 180 / pi;

void measure_junctions(Statistics& s, const CrackGraph& graph,
                       const std::vector<std::vector<double>>& sectors,
                       const std::vector<char>& counted, const StatisticsOptions& o) {
  std::int64_t ends = 0, threes = 0, crosses = 0, t = 0, y = 0;
  std::vector<double> degree, smallest, middle, largest, leg;
  const double tolerance = o.tolerance / degrees;
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    if (!counted[n]) continue;
    const std::size_t d = sectors[n].size();
    ends += d == 1;
    threes += d == 3;
    crosses += d > 3;
    if (d > 2) degree.push_back(static_cast<double>(d));
    if (d != 3) continue;
    std::vector<double> a = sectors[n];
    std::sort(a.begin(), a.end());
    smallest.push_back(a[0] * degrees);
    middle.push_back(a[1] * degrees);
    largest.push_back(a[2] * degrees);
    for (const double angle : a) s.samples.angles.push_back(angle * degrees);
    const JunctionShape shape = junction_shape(a, tolerance);
    y += shape == JunctionShape::y;
    if (shape != JunctionShape::t) continue;
    ++t;
    leg.push_back(180 * a[0] / (a[0] + a[1]));  // against a crossbar made straight
  }
  const std::int64_t all = ends + threes + crosses;
  s.junctions = threes + crosses;
  s.ends = fraction_of(ends, all);
  s.threes = fraction_of(threes, all);
  s.crosses = fraction_of(crosses, all);
  s.mean_degree = mean_of(degree);
  s.angle_min = mean_of(smallest);
  s.angle_mid = mean_of(middle);
  s.angle_max = mean_of(largest);
  s.angle_sd = bootstrap(smallest.size(), o.bootstrap, [&](const std::vector<double>& w) {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
      for (const double a : {smallest[i], middle[i], largest[i]}) {
        sum += w[i];
        squares += w[i] * (a - 120) * (a - 120);  // the mean of three is always 120°
      }
    }
    return std::sqrt(squares / sum);
  });
  s.t_fraction = fraction_of(t, threes);
  s.y_fraction = fraction_of(y, threes);
  s.mixed_fraction = fraction_of(threes - t - y, threes);
  s.leg_angle = mean_of(leg);
  s.leg_sd = bootstrap(leg.size(), o.bootstrap, [&](const std::vector<double>& w) {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
      sum += w[i];
      squares += w[i] * (leg[i] - 90) * (leg[i] - 90);
    }
    return std::sqrt(squares / sum);
  });
}

/// Sides of cells and corners of nodes, on the graph without dead ends.
void measure_mosaic(Statistics& s, const CrackGraph& mosaic,
                    const std::vector<std::vector<double>>& sectors,
                    const std::vector<char>& counted, const std::vector<Cell>& cells,
                    const StatisticsOptions& o) {
  const double tolerance = o.tolerance / degrees;
  std::vector<double> corners, regular;
  for (std::size_t n = 0; n < mosaic.nodes().size(); ++n) {
    if (!counted[n] || sectors[n].size() < 3) continue;
    double c = 0;
    for (const double a : sectors[n]) c += a < pi - tolerance;
    corners.push_back(c);
    regular.push_back(c == static_cast<double>(sectors[n].size()) ? 1 : 0);
  }
  s.corner_degree = mean_of(corners);
  s.regular = fraction_of(std::count(regular.begin(), regular.end(), 1.0),
                          static_cast<std::int64_t>(regular.size()));
  s.sides_from_nodes = bootstrap(corners.size(), o.bootstrap, [&](const std::vector<double>& w) {
    double sum = 0, v = 0, p = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
      sum += w[i];
      v += w[i] * corners[i];
      p += w[i] * regular[i];
    }
    return 2 * v / (v - sum - p);
  });
  std::vector<double> weight, sides, nodes, curvature, flat;
  for (const Cell& c : cells) {
    if (c.border) continue;
    weight.push_back(c.weight);
    sides.push_back(c.corners);
    nodes.push_back(c.nodes);
    curvature.push_back(c.curvature);
    flat.push_back(1 - c.curvature / (2 * pi));
  }
  s.sides = mean_of(sides, weight);
  s.sides_combinatorial = mean_of(nodes, weight);
  s.curvature = mean_of(curvature, weight);
  s.sides_flat = ratio_of(sides, flat, weight);
  s.samples.sides = sides;
}

void measure_areas(Statistics& s, const std::vector<Cell>& cells, const CrackGraphInput& input,
                   const StatisticsOptions& o) {
  std::vector<double> weight, area, perimeter, roundness;
  for (const Cell& c : cells) {
    if (c.border) continue;
    weight.push_back(c.weight);
    area.push_back(c.area);
    perimeter.push_back(c.perimeter);
    roundness.push_back(4 * pi * c.area / (c.perimeter * c.perimeter));
  }
  s.cells = static_cast<std::int64_t>(area.size());
  s.cells_found = static_cast<std::int64_t>(cells.size());
  s.mean_area = mean_of(area, weight);
  s.root_area = {std::sqrt(s.mean_area.value),
                 s.mean_area.error / std::sqrt(s.mean_area.value) / 2};
  std::vector<double> twice = area;
  for (double& a : twice) a *= 2;
  s.area_over_perimeter = ratio_of(twice, perimeter, weight);
  const auto weighted = [&](const std::vector<double>& drawn) {
    std::vector<double> w = drawn;
    for (std::size_t i = 0; i < w.size(); ++i) w[i] *= weight[i];
    return w;
  };
  s.circularity = mean_of(roundness, weight);
  if (area.size() < 2) return;
  s.area_cv = bootstrap(area.size(), o.bootstrap, [&](const std::vector<double>& drawn) {
    return variation(area, weighted(drawn));
  });
  s.circularity_sd = bootstrap(area.size(), o.bootstrap, [&](const std::vector<double>& drawn) {
    const std::vector<double> w = weighted(drawn);
    double sum = 0, mean = 0;
    for (std::size_t i = 0; i < w.size(); ++i) {
      sum += w[i];
      mean += w[i] * roundness[i];
    }
    return variation(roundness, w) * mean / sum;
  });
  // One set of resamples serves the three numbers of the fit.
  const auto fit = [&](double AreaLaw::*member) {
    return bootstrap(area.size(), o.bootstrap, [&](const std::vector<double>& drawn) {
      return fit_area_law(area, weighted(drawn)).*member;
    });
  };
  s.area_sd_log = fit(&AreaLaw::sd_log);
  s.gamma_shape = fit(&AreaLaw::gamma_shape);
  s.gamma_over_lognormal = fit(&AreaLaw::log_likelihood);
  s.samples.areas = area;
  for (double& a : s.samples.areas) a /= s.mean_area.value;

  const std::vector<double>& pieces = input.piece_areas.empty() ? area : input.piece_areas;
  double mean = 0;
  for (const double a : pieces) mean += a / static_cast<double>(pieces.size());
  s.slivers = fraction_of(
      std::count_if(pieces.begin(), pieces.end(), [&](double a) { return a < 0.02 * mean; }),
      static_cast<std::int64_t>(pieces.size()));
}

/// Crack length per area in units of 1/√Ā, and the lines between junctions.
void measure_lines(Statistics& s, const CrackGraph& graph, const CrackGraph& mosaic,
                   const std::vector<char>& counted, const std::vector<Cell>& cells,
                   const Pattern& pattern, const StatisticsOptions& o) {
  for (const auto& e : graph.edges()) s.crack_length += e.border ? 0 : e.length;
  s.surface_area = pattern.input.surface_area;
  if (s.surface_area == 0 && pattern.window) s.surface_area = pattern.window->area();
  std::vector<double> weight, half, area;
  for (const Cell& c : cells) {
    if (c.border) continue;
    weight.push_back(c.weight);
    half.push_back(c.perimeter / 2);
    area.push_back(c.area);
  }
  const double unit = pattern.unit;
  s.length_per_area = ratio_of(half, area, weight);
  if (s.surface_area > 0) s.length_per_area.value = s.crack_length / s.surface_area;
  s.length_per_area.value *= unit;
  s.length_per_area.error *= unit;

  std::vector<double> length, chord;
  for (std::size_t e = 0; e < mosaic.edges().size(); ++e) {
    const auto id = static_cast<std::int32_t>(e);
    const CrackGraph::Edge& edge = mosaic.edges()[e];
    if (!mosaic.is_alive(id) || edge.border) continue;
    if (!counted[mosaic.origin(2 * id)] && !counted[mosaic.target(2 * id)]) continue;
    if (mosaic.nodes()[mosaic.origin(2 * id)].border) continue;
    if (mosaic.nodes()[mosaic.target(2 * id)].border) continue;
    length.push_back(edge.length);
    chord.push_back((edge.points.back() - edge.points.front()).norm());
  }
  s.edges = static_cast<std::int64_t>(length.size());
  s.tortuosity = ratio_of(length, chord);
  s.edge_cv = bootstrap(length.size(), o.bootstrap,
                        [&](const std::vector<double>& w) { return variation(length, w); });
}

Statistics measure(const Pattern& pattern, double simplify, const StatisticsOptions& o) {
  const Context& context = o.bootstrap.context;
  context.check();
  const BranchFit fit = pattern.fit();
  const double tolerance = o.tolerance / degrees;
  const CrackGraph graph = pattern.simplified(simplify);
  CrackGraph mosaic = graph;
  mosaic.remove_dead_ends();
  context.check();
  const auto sectors = all_sector_angles(graph, fit);
  const auto mosaic_sectors = all_sector_angles(mosaic, fit);
  const auto cells =
      find_cells(mosaic, mosaic_sectors, tolerance, pattern.input.piece_areas, pattern.window);
  context.check();
  std::vector<char> counted = pattern.near_border_nodes(graph);
  for (char& c : counted) c = !c;  // nodes keep their index in the mosaic

  Statistics s;
  measure_junctions(s, graph, sectors, counted, o);
  measure_areas(s, cells, pattern.input, o);
  context.check();
  measure_mosaic(s, mosaic, mosaic_sectors, counted, cells, o);
  context.check();
  measure_lines(s, graph, mosaic, counted, cells, pattern, o);
  context.check();
  const Anisotropy a = measure_anisotropy(graph, o.axis, o.bootstrap);
  s.anisotropy = a.strength;
  s.anisotropy_null = a.null;
  s.direction_entropy = a.entropy;
  s.direction = a.direction;
  s.direction_rms = a.rms_deviation;
  context.check();
  const CrackOrder order = measure_order(graph, sectors, tolerance, counted, o.bootstrap);
  s.leg_younger = order.leg_younger;
  s.kendall_tau = order.kendall_tau;

  // A picture without a drawn border cuts cracks off: their ends near its frame are no tips.
  const bool framed = pattern.window && !pattern.window->drawn;
  const std::vector<char> ignored = framed ? pattern.near_border_nodes(pattern.raw)
                                           : std::vector<char>(pattern.raw.nodes().size(), 0);
  context.check();
  const Flaws flaws = measure_flaws(pattern.raw, pattern.unit, ignored);
  s.dead_ends = flaws.dead_ends;
  s.spurs = flaws.spurs;
  s.micro_cracks = flaws.micro_cracks;
  return s;
}

}  // namespace

Statistics compute_statistics(const CrackGraphInput& input, const StatisticsOptions& options) {
  options.bootstrap.context.report({"statistics"});
  return measure(Pattern(input, options), options.simplify, options);
}

StatisticsWithSensitivity compute_with_sensitivity(const CrackGraphInput& input,
                                                   const StatisticsOptions& options) {
  options.bootstrap.context.report({"statistics"});
  const Pattern pattern(input, options);
  StatisticsOptions quick = options;
  quick.bootstrap.resamples = 0;
  return {measure(pattern, options.simplify, options),
          measure(pattern, options.simplify / 2, quick),
          measure(pattern, options.simplify * 2, quick)};
}

}  // namespace craze
