#include "craze/job/dataset/scene/whole_cracks.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <tuple>

#include "craze/base/elementary.h"
#include "craze/products/statistics/graph/plane_frame.h"
#include "craze/products/statistics/measures/junction_angles.h"

namespace craze {

namespace {

/// End 2e of edge e is at its node a, 2e+1 at b.
using End = std::int32_t;

class Ends {
 public:
  explicit Ends(const CrackNetwork& network) : network_(network), at_(network.nodes.size()) {
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
      at_[network.edges[e].a].push_back(static_cast<End>(2 * e));
      at_[network.edges[e].b].push_back(static_cast<End>(2 * e + 1));
    }
  }
  const std::vector<End>& at(std::int32_t node) const { return at_[node]; }
  std::int32_t node(End end) const {
    const CrackEdge& e = network_.edges[end / 2];
    return end & 1 ? e.b : e.a;
  }
  /// Unit, away from the node of `end`, over three edges or until the crack meets another.
  Vec3 direction(End end) const {
    const Vec3& from = network_.nodes[node(end)].position;
    End far = end ^ 1;
    for (int i = 0; i < 2 && at_[node(far)].size() == 2; ++i) {
      const auto& there = at_[node(far)];
      far = (there[0] == far ? there[1] : there[0]) ^ 1;
    }
    return (network_.nodes[node(far)].position - from).stableNormalized();
  }

 private:
  const CrackNetwork& network_;
  std::vector<std::vector<End>> at_;
};

/// Per end, the one that it runs on into; −1: none.
std::vector<End> joined_ends(const CrackNetwork& network, const Ends& ends) {
  constexpr double turns_less_than_45 = -std::numbers::sqrt2 / 2;
  std::vector<End> on(2 * network.edges.size(), -1);
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    const auto& here = ends.at(static_cast<std::int32_t>(n));
    if (here.size() < 2 || network.nodes[n].kind == JunctionKind::border) continue;
    std::vector<std::tuple<double, End, End>> pairs;
    for (std::size_t i = 0; i < here.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double c = ends.direction(here[i]).dot(ends.direction(here[j]));
        if (here.size() == 2 || c < turns_less_than_45) pairs.emplace_back(c, here[j], here[i]);
      }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [c, a, b] : pairs) {
      if (on[a] >= 0 || on[b] >= 0) continue;
      on[a] = b;
      on[b] = a;
    }
  }
  return on;
}

WholeCrack follow(const CrackNetwork& network, const Ends& ends, const std::vector<End>& on,
                  End first, std::vector<char>& taken) {
  WholeCrack crack;
  crack.nodes.push_back(ends.node(first));
  for (End end = first; end >= 0 && !taken[end / 2]; end = on[end ^ 1]) {
    taken[end / 2] = 1;
    crack.edges.push_back(end / 2);
    crack.nodes.push_back(ends.node(end ^ 1));
  }
  const auto moment = [&](std::int32_t e) {
    return std::pair(network.edges[e].time, network.edges[e].event);
  };
  auto begun = moment(crack.edges.front());
  for (const std::int32_t e : crack.edges) begun = std::min(begun, moment(e));
  std::tie(crack.time, crack.event) = begun;
  return crack;
}

void find_parents(const CrackNetwork& network, const Ends& ends, std::vector<WholeCrack>& cracks) {
  std::vector<std::int32_t> crack_of(network.edges.size());
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    for (const std::int32_t e : cracks[c].edges) crack_of[e] = static_cast<std::int32_t>(c);
  }
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    // Cracks are in the order of opening: the oldest has the least index.
    auto oldest = static_cast<std::int32_t>(c);
    for (const std::int32_t tip : {cracks[c].nodes.front(), cracks[c].nodes.back()}) {
      for (const End end : ends.at(tip)) oldest = std::min(oldest, crack_of[end / 2]);
    }
    if (oldest < static_cast<std::int32_t>(c)) cracks[c].parent = oldest;
  }
}

}  // namespace

std::vector<WholeCrack> whole_cracks(const CrackNetwork& network) {
  const Ends ends(network);
  const std::vector<End> on = joined_ends(network, ends);
  std::vector<char> taken(network.edges.size(), 0);
  std::vector<WholeCrack> cracks;
  // Open cracks from their ends, then closed ones.
  for (const bool closed : {false, true}) {
    for (End end = 0; end < static_cast<End>(on.size()); ++end) {
      if (taken[end / 2] || (!closed && on[end] >= 0)) continue;
      cracks.push_back(follow(network, ends, on, end, taken));
    }
  }
  std::stable_sort(cracks.begin(), cracks.end(), [](const WholeCrack& a, const WholeCrack& b) {
    return std::pair(a.time, a.event) < std::pair(b.time, b.event);
  });
  for (std::size_t c = 0; c < cracks.size(); ++c)
    cracks[c].order = static_cast<std::int32_t>(c) + 1;
  find_parents(network, ends, cracks);
  return cracks;
}

std::vector<std::string_view> junction_kinds(const CrackNetwork& network) {
  constexpr double tolerance = 20 * std::numbers::pi / 180;
  const Ends ends(network);
  std::vector<std::string_view> kinds;
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    const CrackNode& node = network.nodes[n];
    const auto& here = ends.at(static_cast<std::int32_t>(n));
    if (node.kind != JunctionKind::junction) {
      kinds.push_back(node.kind == JunctionKind::border ? "border"
                      : node.kind == JunctionKind::end  ? "end"
                                                        : "");
      continue;
    }
    if (here.size() > 3) {
      kinds.push_back("x");
      continue;
    }
    const Mat32 frame = plane_frame(node.normal);
    std::vector<double> angles, sectors;
    for (const End end : here) {
      const Vec2 d = frame.transpose() * ends.direction(end);
      angles.push_back(elementary::atan2(d.y(), d.x()));
    }
    std::sort(angles.begin(), angles.end());
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * std::numbers::pi;
      sectors.push_back(next - angles[i]);
    }
    const JunctionShape shape = junction_shape(sectors, tolerance);
    kinds.push_back(shape == JunctionShape::t ? "t" : shape == JunctionShape::y ? "y" : "other");
  }
  return kinds;
}

}  // namespace craze
