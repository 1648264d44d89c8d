#include "craze/engine/roughness/rough_network.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "craze/base/elementary.h"
#include "craze/base/parallel.h"
#include "craze/base/random.h"
#include "craze/engine/roughness/crack_chains.h"
#include "craze/engine/roughness/crack_room.h"
#include "craze/engine/roughness/self_affine_profile.h"

namespace craze {

namespace {

constexpr std::uint64_t stream = 0x726f756768;  // "rough"
constexpr double steps_of_usual = 16;
constexpr int most_halvings = 18;
// Reach of the look around, in the highest heights: what has so much room is hardly held back.
constexpr double ample_room = 4;
constexpr double farthest = 0.5;     // that reach, in usual lengths
constexpr double strip_share = 0.8;  // of what turns a strip between two points over
constexpr std::size_t chains_at_once = 8;

/// What is moved on one chain: 2^halvings + 1 points at even distances.
struct Profile {
  std::vector<double> heights;
  double held_back = 0;  // length
};

double mean_edge(const CrackNetwork& network) {
  return total_length(network) / static_cast<double>(network.edges.size());
}

/// h, but less than the room; h itself where that is ample.
double within(double h, double room) {
  if (!(room > 0)) return 0;
  const double share = h / room;
  return h / std::sqrt(1 + share * share);
}

class Roughener {
 public:
  Roughener(const CrackNetwork& network, const RoughnessOptions& options)
      : network_(network),
        chains_(crack_chains(network)),
        usual_(usual_length(chains_)),
        window_(mean_edge(network)),
        exponent_(options.exponent),
        amplitude_(std::min(options.amplitude, usual_)),
        closed_(options.closed) {
    // Finer, the lines would be steeper than 45 degrees, or their points too many.
    const double steepest =
        usual_ * elementary::pow(amplitude_ / usual_, 1 / (1 - options.exponent));
    const double most = 2 * total_length(network) / most_points;
    step_ = std::max({options.step > 0 ? options.step : usual_ / steps_of_usual, steepest, most});
    name_chains(options.seed);
  }

  RoughNetwork run(const TriangleMesh& mesh, const Context& context) {
    std::vector<Profile> profiles(chains_.size());
    for_each_chain(context, [&](std::size_t c) { profiles[c].heights = free_heights(c); });
    double highest = 0;
    for (const Profile& p : profiles) {
      for (const double h : p.heights) highest = std::max(highest, std::abs(h));
    }
    if (highest > 0) {
      double reach = std::min(ample_room * highest, farthest * usual_);
      if (network_.period.is_given()) reach = std::min(reach, network_.period.length / 8);
      const CrackRoom room(network_, chains_, mesh, closed_, reach, 2 * window_);
      for_each_chain(context, [&](std::size_t c) { hold_back(c, room, profiles[c]); });
    }
    return drawn(profiles);
  }

 private:
  template <class Do>
  void for_each_chain(const Context& context, Do&& act) const {
    parallel_for(context.threads, chains_.size(), chains_at_once,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t c = begin; c < end; ++c) act(c);
                 });
    context.check();
  }

  /// A chain goes by the first event on it, those that share one by their order.
  void name_chains(std::uint64_t seed) {
    std::map<std::int32_t, std::uint64_t> with_event;
    for (const CrackChain& chain : chains_) {
      std::int32_t first = network_.edges[chain.edges[0]].event;
      for (const std::int32_t e : chain.edges) first = std::min(first, network_.edges[e].event);
      const std::uint64_t same = with_event[first]++;
      randoms_.emplace_back(hash_bits(seed ^ hash_bits(same)),
                            stream ^ hash_bits(static_cast<std::uint64_t>(first)));
    }
  }

  int halvings(const CrackChain& chain) const {
    const double pieces = std::max(chain.length / step_, static_cast<double>(chain.edges.size()));
    int k = 1;
    while (k < most_halvings && static_cast<double>(1 << k) < pieces) ++k;
    return k;
  }

  std::vector<double> free_heights(std::size_t c) const {
    const CrackChain& chain = chains_[c];
    std::vector<double> heights = self_affine_profile(halvings(chain), exponent_, randoms_[c]);
    const double scale = amplitude_ * elementary::pow(chain.length / usual_, exponent_);
    for (double& h : heights) h *= scale;
    return heights;
  }

  /// Where point i of a chain in n steps lies, and which way it is moved.
  MovingPlace place(std::size_t c, const ChainLine& line, std::size_t i, std::size_t n) const {
    const double s = line.length() * (static_cast<double>(i) / static_cast<double>(n));
    const ChainPlace at = line.at(s);
    const Vec3 way = line.direction(s, window_);
    const Vec3 tangent = (way - way.dot(at.normal) * at.normal).stableNormalized();
    return {at.position, at.normal, tangent, static_cast<std::int32_t>(c), s};
  }
  static Vec3 aside(const MovingPlace& place) { return place.normal.cross(place.tangent); }

  /// How far both of two neighbours may move before the strip between them turns over.
  static double room_between(const MovingPlace& p, const MovingPlace& q) {
    const Vec3 along = p.tangent + q.tangent;
    const double ahead = (q.position - p.position).dot(along);
    const double turn = std::abs((aside(q) - aside(p)).dot(along));
    if (ahead <= 0) return 0;
    return turn > 0 ? strip_share * ahead / turn : std::numeric_limits<double>::infinity();
  }

  void hold_back(std::size_t c, const CrackRoom& room, Profile& profile) const {
    const ChainLine line(chains_[c], network_);
    const std::size_t n = profile.heights.size() - 1;
    std::size_t held = 0;
    MovingPlace here = place(c, line, 0, n);
    double before = 0;
    for (std::size_t i = 1; i < n; ++i) {
      const MovingPlace last = here;
      here = place(c, line, i, n);
      if (i == 1) before = room_between(last, here);
      const double after = room_between(here, place(c, line, i + 1, n));
      double& h = profile.heights[i];
      const double free = std::abs(h);
      h = within(h, std::min({room.around(here), before, after}));
      if (std::abs(h) < free / 2) ++held;
      before = after;
    }
    profile.held_back = chains_[c].length * static_cast<double>(held) / static_cast<double>(n);
  }

  RoughNetwork drawn(const std::vector<Profile>& profiles) {
    RoughNetwork rough;
    rough.network.period = network_.period;
    rough.step = step_;
    std::vector<std::int32_t> kept(network_.nodes.size(), -1);  // ends of chains
    const auto keep = [&](std::int32_t node) {
      if (kept[node] < 0) {
        kept[node] = static_cast<std::int32_t>(rough.network.nodes.size());
        rough.network.nodes.push_back(network_.nodes[node]);
      }
      return kept[node];
    };
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      const CrackChain& chain = chains_[c];
      const ChainLine line(chain, network_);
      const std::size_t n = profiles[c].heights.size() - 1;
      std::int32_t from = keep(chain.nodes.front());
      for (std::size_t i = 1; i <= n; ++i) {
        const std::int32_t to =
            i == n ? keep(chain.nodes.back())
                   : add_bend(place(c, line, i, n), profiles[c].heights[i], chain, line, rough);
        add_edge(chain, line, i, n, from, to, rough);
        from = to;
      }
      rough.held_back += profiles[c].held_back;
    }
    rough.held_back /= total_length(network_);
    return rough;
  }

  std::int32_t add_bend(const MovingPlace& at, double height, const CrackChain& chain,
                        const ChainLine& line, RoughNetwork& rough) const {
    const CrackEdge& parent = network_.edges[chain.edges[line.at(at.arc).index]];
    rough.network.nodes.push_back(
        {at.position + height * aside(at), at.normal, parent.face, JunctionKind::bend, -1});
    return static_cast<std::int32_t>(rough.network.nodes.size()) - 1;
  }

  /// Step i of n of a chain.
  void add_edge(const CrackChain& chain, const ChainLine& line, std::size_t i, std::size_t n,
                std::int32_t from, std::int32_t to, RoughNetwork& rough) const {
    const double step = line.length() / static_cast<double>(n);
    const std::size_t j = line.at((static_cast<double>(i) - 0.5) * step).index;
    const double start = line.start(j), end = line.start(j + 1);
    const auto share = [&](std::size_t k) {
      const double length = end - start;
      return length > 0 ? std::clamp((static_cast<double>(k) * step - start) / length, 0.0, 1.0)
                        : 0.0;
    };
    SmoothPiece piece{chain.edges[j], {share(i - 1), share(i)}};
    CrackEdge edge = network_.edges[piece.edge];
    const bool forward = edge.a == chain.nodes[j];
    edge.side = -1;
    edge.a = forward ? from : to;
    edge.b = forward ? to : from;
    if (!forward) piece.shares = {1 - piece.shares[1], 1 - piece.shares[0]};
    rough.network.edges.push_back(edge);
    rough.pieces.push_back(piece);
  }

  const CrackNetwork& network_;
  std::vector<CrackChain> chains_;
  double usual_, window_, exponent_, amplitude_, step_ = 0;
  const std::vector<std::uint8_t>& closed_;  // of the options
  std::vector<Random> randoms_;              // per chain
};

}  // namespace

RoughNetwork roughen(const CrackNetwork& network, const TriangleMesh& mesh,
                     const RoughnessOptions& options, const Context& context) {
  if (network.edges.empty()) return {network, {}, 0, 0};
  return Roughener(network, options).run(mesh, context);
}

}  // namespace craze
