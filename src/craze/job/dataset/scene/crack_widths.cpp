#include "craze/job/dataset/scene/crack_widths.h"

#include <algorithm>
#include <cmath>

#include "craze/render/material/noise.h"

namespace craze {

namespace {

constexpr double least_share = 0.25, largest_share = 3;  // of the mean width

double edge_length(const CrackNetwork& network, std::int32_t e) {
  const CrackEdge& edge = network.edges[e];
  return (network.nodes[edge.b].position - network.nodes[edge.a].position).norm();
}

/// Mean opening of the edges by length.
double mean_opening(const CrackNetwork& network, const std::vector<std::int32_t>& edges) {
  double sum = 0, length = 0;
  for (const std::int32_t e : edges) {
    const double l = edge_length(network, e);
    sum += l * network.edges[e].width;
    length += l;
  }
  return length > 0 ? sum / length : 0;
}

/// How far each node is along the crack from its first.
std::vector<double> ways(const CrackNetwork& network, const WholeCrack& crack) {
  std::vector<double> way(1, 0.0);
  for (const std::int32_t e : crack.edges) way.push_back(way.back() + edge_length(network, e));
  return way;
}

}  // namespace

CrackWidths crack_widths(const CrackNetwork& network, const std::vector<WholeCrack>& cracks,
                         const WidthStyle& style) {
  std::vector<std::int32_t> all;
  for (std::size_t e = 0; e < network.edges.size(); ++e)
    all.push_back(static_cast<std::int32_t>(e));
  const double overall = mean_opening(network, all);
  const Random random(style.seed);
  const render::Vec3f shift(static_cast<float>(100 * random.uniform_at(0)),
                            static_cast<float>(100 * random.uniform_at(1)),
                            static_cast<float>(100 * random.uniform_at(2)));
  const double wave = 6 * style.mean;  // over which the unevenness is alike
  CrackWidths widths;
  for (const WholeCrack& crack : cracks) {
    const double opening = overall > 0 ? mean_opening(network, crack.edges) / overall : 1;
    const double share = std::clamp(opening, least_share, largest_share);
    const double wide = style.mean * (style.even + (1 - style.even) * share);
    const std::vector<double> way = ways(network, crack);
    const auto is_tip = [&](std::int32_t n) { return network.nodes[n].kind == JunctionKind::end; };
    std::vector<double> of_crack;
    for (std::size_t i = 0; i < crack.nodes.size(); ++i) {
      double w = wide;
      if (style.unevenness > 0) {
        const render::Vec3f place = (network.nodes[crack.nodes[i]].position / wave).cast<float>();
        const float noise = render::fractal_noise(place + shift, 2).value;
        w *= std::max(0.2, 1 + 2 * style.unevenness * static_cast<double>(noise));
      }
      // A free tip closes like a crack in an elastic sheet: with the root of the way.
      const auto closing = [&](double s) {
        return style.taper > 0 && s < style.taper ? std::sqrt(s / style.taper) : s > 0 ? 1.0 : 0.0;
      };
      if (is_tip(crack.nodes.front())) w *= closing(way[i]);
      if (is_tip(crack.nodes.back())) w *= closing(way.back() - way[i]);
      of_crack.push_back(w);
    }
    widths.push_back(std::move(of_crack));
  }
  return widths;
}

}  // namespace craze
