#include "craze/products/growth/crack_schedule.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace craze {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
/// Steps of load smaller than this part of the whole belong to one run of a crack.
constexpr double same_run = 0.02;

/// The network's edges, in the order in which they opened, between sites.
struct Edge {
  std::int32_t a, b;  ///< it grew from a to b
  double length;
  double load;                ///< 0: the first crack's, 1: the last one's
  double start = 0, end = 0;  ///< when the crack is at a and at b
};

/// Appends the edges of one event, each after that which it goes on from, else as they were.
void append_in_growth(const CrackNetwork& network, const std::vector<std::size_t>& of_event,
                      std::vector<std::size_t>& order) {
  std::unordered_map<std::int32_t, std::size_t> ending_at;  // node: which of them
  for (std::size_t i = 0; i < of_event.size(); ++i) {
    ending_at.emplace(network.edges[of_event[i]].b, i);
  }
  std::vector<bool> is_done(of_event.size(), false);
  std::vector<std::size_t> backwards;
  for (std::size_t i = 0; i < of_event.size(); ++i) {
    for (std::size_t k = i; !is_done[k];) {
      is_done[k] = true;
      backwards.push_back(of_event[k]);
      const auto before = ending_at.find(network.edges[of_event[k]].a);
      if (before != ending_at.end()) k = before->second;
    }
    order.insert(order.end(), backwards.rbegin(), backwards.rend());
    backwards.clear();
  }
}

/// The edges of a network, of which roughness makes lines from junction to junction, in the order
/// in which they opened.
std::vector<std::size_t> in_growth(const CrackNetwork& network) {
  std::vector<std::size_t> by_event(network.edges.size()), order;
  std::iota(by_event.begin(), by_event.end(), std::size_t{0});
  const auto event = [&](std::size_t e) { return network.edges[e].event; };
  std::stable_sort(by_event.begin(), by_event.end(),
                   [&](std::size_t e, std::size_t f) { return event(e) < event(f); });
  std::vector<std::size_t> of_event;
  for (std::size_t i = 0; i < by_event.size(); ++i) {
    of_event.push_back(by_event[i]);
    if (i + 1 < by_event.size() && event(by_event[i + 1]) == event(by_event[i])) continue;
    append_in_growth(network, of_event, order);
    of_event.clear();
  }
  return order;
}

std::vector<Edge> edges_between_sites(const CrackSites& sites, const CrackNetwork& network) {
  double first = never, last = -never;
  for (const CrackEdge& edge : network.edges) {
    first = std::min(first, edge.time);
    last = std::max(last, edge.time);
  }
  std::vector<Edge> edges;
  for (const std::size_t e : in_growth(network)) {
    const CrackEdge& edge = network.edges[e];
    const CrackNode &a = network.nodes[edge.a], &b = network.nodes[edge.b];
    edges.push_back({sites.site_of[a.vertex], sites.site_of[b.vertex],
                     (b.position - a.position).norm(),
                     last > first ? (edge.time - first) / (last - first) : 0});
  }
  return edges;
}

/// The longest way that a crack ran at about one load.
double longest_run_of(const std::vector<Edge>& edges, std::size_t sites) {
  std::vector<double> load(sites, never), run(sites, 0);
  double longest = 0;
  for (const Edge& e : edges) {
    load[e.a] = std::min(load[e.a], e.load);
    if (load[e.b] != never) continue;
    load[e.b] = e.load;
    run[e.b] = (e.load - load[e.a] <= same_run ? run[e.a] : 0) + e.length;
    longest = std::max(longest, run[e.b]);
  }
  return longest;
}

/// Sets start and end of the edges; returns when the first crack comes to each site.
std::vector<double> run_cracks(std::vector<Edge>& edges, std::size_t sites) {
  const double longest = longest_run_of(edges, sites);
  const double pace = longest > 0 ? CrackSchedule::longest_run / longest : 0;
  constexpr double for_loads = 1 - CrackSchedule::longest_run - CrackSchedule::opening_time;
  std::vector<double> arrival(sites, never);
  double last = 0;
  for (Edge& e : edges) {
    const double load = for_loads * e.load;
    if (arrival[e.a] == never) arrival[e.a] = load;
    e.start = std::max(arrival[e.a], load);
    e.end = e.start + pace * e.length;
    if (arrival[e.b] == never) arrival[e.b] = e.end;
    last = std::max(last, e.end);
  }
  // Cracks that start from late ones may run over.
  constexpr double latest = 1 - CrackSchedule::opening_time;
  const double scale = last > latest ? latest / last : 1;
  for (Edge& e : edges) {
    e.start *= scale;
    e.end *= scale;
  }
  // A crack may have waited, so that a later one comes first.
  std::fill(arrival.begin(), arrival.end(), never);
  for (const Edge& e : edges) {
    arrival[e.a] = std::min(arrival[e.a], e.start);
    arrival[e.b] = std::min(arrival[e.b], e.end);
  }
  return arrival;
}

/// Sites where the network has no node, since the sides were split after it was made, open with
/// the first of those beside them.
void fill_between(const TriangleMesh& mesh, const CrackSites& sites, std::vector<double>& arrival) {
  for (bool again = true; again;) {
    again = false;
    std::vector<double> next = arrival;
    for (std::size_t i = 0; i < sites.sides.size(); ++i) {
      std::int32_t before = sites.site_of[mesh.from(sites.sides[i])];
      const auto pass = [&](std::int32_t site) {
        for (const auto& [to, from] : {std::pair{site, before}, std::pair{before, site}}) {
          if (arrival[to] != never || !(arrival[from] < next[to])) continue;
          next[to] = arrival[from];
          again = true;
        }
        before = site;
      };
      for (std::int32_t k = sites.first[i]; k < sites.first[i + 1]; ++k) pass(sites.inner[k]);
      pass(sites.site_of[mesh.to(sites.sides[i])]);
    }
    arrival = std::move(next);
  }
}

}  // namespace

double CrackSchedule::openness(double arrival, double time) {
  const double t = std::clamp((time - arrival) / opening_time, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

CrackSchedule crack_schedule(const TriangleMesh& mesh, const CrackSites& sites,
                             const CrackNetwork& network) {
  std::vector<Edge> edges = edges_between_sites(sites, network);
  CrackSchedule schedule;
  schedule.sites = run_cracks(edges, sites.vertex.size());
  fill_between(mesh, sites, schedule.sites);

  using Ends = std::array<std::int32_t, 2>;
  std::map<Ends, std::array<double, 2>> times;
  for (const Edge& e : edges) {
    times[{e.a, e.b}] = {e.start, e.end};
    times[{e.b, e.a}] = {e.end, e.start};
  }
  const auto time_at = [&](std::int32_t a, std::int32_t b, int end) {
    const auto found = times.find({a, b});
    return found == times.end() ? schedule.sites[end == 0 ? a : b] : found->second[end];
  };
  for (std::size_t i = 0; i < sites.sides.size(); ++i) {
    const std::int32_t h = sites.sides[i];
    const std::int32_t a = sites.site_of[mesh.from(h)], b = sites.site_of[mesh.to(h)];
    schedule.sides.push_back(
        {time_at(a, sites.after_from(mesh, i), 0), time_at(sites.before_to(mesh, i), b, 1)});
  }
  return schedule;
}

}  // namespace craze
