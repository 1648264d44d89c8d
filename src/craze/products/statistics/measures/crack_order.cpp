#include "craze/products/statistics/measures/crack_order.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace craze {
namespace {

/// Later is greater; NaN first where times are not known.
using Moment = std::pair<double, std::int32_t>;

Moment moment(const CrackGraph::Segment& s) {
  return {std::isnan(s.time) ? 0.0 : s.time, s.event};
}

/// The moment at which the crack passed the origin of d.
Moment moment_at(const CrackGraph& graph, Dart d) {
  const auto& segments = graph.edges()[d / 2].segments;
  return moment(d & 1 ? segments.back() : segments.front());
}

/// Whole cracks: lines joined across the crossbars of T's. Not through X's, of which many are two
/// T's back to back whose legs have nothing to do with each other.
class Cracks {
 public:
  explicit Cracks(const CrackGraph& graph) : parent_(graph.edges().size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::int32_t find(std::int32_t e) {
    while (parent_[e] != e) e = parent_[e] = parent_[parent_[e]];
    return e;
  }
  void join(Dart a, Dart b) { parent_[find(a / 2)] = find(b / 2); }

 private:
  std::vector<std::int32_t> parent_;
};

struct Pairs {
  double concordant = 0, discordant = 0;
};

/// For each crack (up to a few thousand of them, evenly taken): how its ancestors agree in time.
std::vector<Pairs> compare_with_ancestors(const std::vector<std::vector<std::int32_t>>& parents,
                                          const std::vector<Moment>& birth) {
  constexpr std::size_t sample = 2000;
  const std::size_t n = parents.size();
  const std::size_t stride = std::max<std::size_t>(1, n / sample);
  std::vector<Pairs> pairs;
  std::vector<std::size_t> seen(n, n);
  std::vector<std::int32_t> queue;
  for (std::size_t c = 0; c < n; c += stride) {
    if (parents[c].empty()) continue;
    Pairs p;
    queue.assign(1, static_cast<std::int32_t>(c));
    seen[c] = c;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const std::int32_t a : parents[queue[i]]) {
        if (seen[a] == c) continue;
        seen[a] = c;
        queue.push_back(a);
        p.concordant += birth[c] > birth[a];
        p.discordant += birth[c] < birth[a];
      }
    }
    pairs.push_back(p);
  }
  return pairs;
}

}  // namespace

CrackOrder measure_order(const CrackGraph& graph, const std::vector<std::vector<double>>& sectors,
                         double tolerance, const std::vector<char>& counted,
                         const Bootstrap& options) {
  CrackOrder order;
  bool known = false;
  for (const auto& edge : graph.edges()) {
    for (const auto& s : edge.segments) known |= !edge.border && (s.event >= 0 || s.time >= 0);
  }
  if (!known) return order;

  Cracks cracks(graph);
  std::vector<std::pair<Dart, Dart>> legs;  // leg, and one half of its crossbar
  std::int64_t younger = 0, decided = 0;
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    const CrackGraph::Node& node = graph.nodes()[n];
    if (node.border) continue;
    if (node.darts.size() != 3 || junction_shape(sectors[n], tolerance) != JunctionShape::t) {
      continue;
    }
    const TParts t = t_parts(node, sectors[n]);
    cracks.join(t.crossbar[0], t.crossbar[1]);
    legs.emplace_back(t.leg, t.crossbar[0]);
    if (!counted[n]) continue;
    const Moment leg = moment_at(graph, t.leg);
    const auto [first, last] =
        std::minmax({moment_at(graph, t.crossbar[0]), moment_at(graph, t.crossbar[1])});
    if (leg == first || leg == last) continue;
    ++decided;
    younger += leg > last;
  }
  order.leg_younger = fraction_of(younger, decided);

  std::vector<Moment> birth(graph.edges().size(), {std::numeric_limits<double>::infinity(), 0});
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    if (graph.edges()[e].border) continue;
    Moment& b = birth[cracks.find(static_cast<std::int32_t>(e))];
    for (const auto& s : graph.edges()[e].segments) b = std::min(b, moment(s));
  }
  std::vector<std::vector<std::int32_t>> parents(graph.edges().size());
  for (const auto& [leg, bar] : legs) {
    const std::int32_t child = cracks.find(leg / 2), parent = cracks.find(bar / 2);
    if (child != parent) parents[child].push_back(parent);
  }
  const std::vector<Pairs> pairs = compare_with_ancestors(parents, birth);
  order.kendall_tau = bootstrap(pairs.size(), options, [&](const std::vector<double>& drawn) {
    double concordant = 0, discordant = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      concordant += drawn[i] * pairs[i].concordant;
      discordant += drawn[i] * pairs[i].discordant;
    }
    return (concordant - discordant) / (concordant + discordant);
  });
  return order;
}

}  // namespace craze
