#include "craze/products/opening/opening_limit.h"

#include <algorithm>

#include "craze/base/elementary.h"
#include "craze/mesh/self_intersection.h"
#include "craze/products/opening/curl.h"

namespace craze {

namespace {

using Pairs = std::vector<std::array<std::int32_t, 2>>;

constexpr int rounds = 30;
/// What is left of a share after each round in which it was too much.
constexpr double step_back = 0.65;
/// How much larger a share may be than the neighbour's: few vertices do less for one that must.
constexpr double neighbour_ratio = 3;
/// Where all are made smaller, the distance over which a share may grow by the factor e, in
/// natural_curl_length(): about half of a piece, so that pieces shrink as a whole and rims taper.
constexpr double taper_length = 1.5;
/// How far the rims of nearly all pieces may go, in natural_curl_length(): a third of a piece.
constexpr double rim_way = 1, nearly_all = 0.9;
/// Shares below are nothing at all.
constexpr double nothing = 0.03;
/// Walls of this share of their depth are no deeper than need be.
constexpr double shallow = 0.1;

Vec3 area_normal(const std::vector<Vec3>& p, const Triangle& t) {
  return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
}

class Limiter {
 public:
  Limiter(const OpeningMotion& motion, const Context& context)
      : motion_(motion), mesh_(motion.mesh), context_(context) {
    triangles_ = mesh_.triangles();
    triangles_.insert(triangles_.end(), motion.walls.triangles.begin(),
                      motion.walls.triangles.end());
    most_pairs_ = 4 * triangles_.size();
    shares_.move.assign(mesh_.vertex_count(), 1);
    shares_.depth.assign(mesh_.vertex_count(), 1);
  }

  OpeningLimit run() {
    bool sound = false;
    for (int round = 0; round < rounds && !sound; ++round) {
      context_.report({"open", static_cast<double>(round) / rounds});
      context_.check();
      spread(shares_.move,
             [this](std::int32_t h) { return taper_.empty() ? neighbour_ratio : taper_[h]; });
      spread(shares_.depth, [](std::int32_t) { return neighbour_ratio; });
      sound = step(round + 5 < rounds ? step_back : 0);
      if (round == 0 && !sound) begin_smaller();
    }
    OpeningLimit limit;
    if (!sound) {
      const std::vector<Vec3> positions = motion_.positions(shares_);
      limit.folded = static_cast<std::int32_t>(folded(positions).size());
      limit.crossings = static_cast<std::int32_t>(crossings(positions).size());
    }
    for (std::size_t v = 0; v < shares_.move.size(); ++v) {
      const double depth = has_wall(v) ? shares_.depth[v] : 1;
      const double share = std::min(shares_.move[v], depth);
      limit.limited += share < 1 ? 1 : 0;
      limit.least = std::min(limit.least, share);
    }
    limit.shares = std::move(shares_);
    return limit;
  }

 private:
  /// Where all is too much, it is begun anew and smaller everywhere alike: as a smaller opening.
  void begin_smaller() {
    std::vector<double> ways;  // of the rims
    for (std::size_t v = 0; v < motion_.shift.size(); ++v) {
      if (motion_.sites.site_of[v] >= 0) ways.push_back(motion_.shift[v].norm());
    }
    if (ways.empty()) return;
    const auto at = static_cast<std::ptrdiff_t>(nearly_all * static_cast<double>(ways.size()));
    std::nth_element(ways.begin(), ways.begin() + at, ways.end());
    const double natural = natural_curl_length(mesh_, motion_.sites);
    const double way = ways[static_cast<std::size_t>(at)], most = rim_way * natural;
    if (!(way > most)) return;
    for (std::int32_t h = 0; h < 3 * mesh_.face_count(); ++h) {
      taper_.push_back(
          elementary::exp(edge(mesh_.positions(), h).norm() / (taper_length * natural)));
    }
    shares_.move.assign(shares_.move.size(), most / way);
    shares_.depth.assign(shares_.depth.size(), 1);
  }

  /// Takes back where it is too far; true where nothing is.
  bool step(double left) {
    const std::vector<Vec3> positions = motion_.positions(shares_);
    const std::vector<std::int32_t> turned = folded(positions);
    const Pairs pairs = crossings(positions);
    std::vector<std::uint8_t> less_move(shares_.move.size(), 0), less_depth(less_move);
    for (const std::int32_t f : turned) mark(f, less_move);
    for (const auto& [f, g] : pairs) {
      const bool wall = std::max(f, g) >= mesh_.face_count();
      // Walls that hardly go down and still cross do so because their tops overlap.
      auto& marks =
          wall && (largest(f, g, shares_.depth) > shallow || largest(f, g, shares_.move) == 0)
              ? less_depth
              : less_move;
      mark(f, marks);
      mark(g, marks);
    }
    take(less_move, left, shares_.move);
    take(less_depth, left, shares_.depth);
    return turned.empty() && pairs.empty();
  }

  void mark(std::int32_t face, std::vector<std::uint8_t>& marks) const {
    for (const std::int32_t v : triangles_[face]) marks[top_of(v)] = 1;
  }

  static void take(const std::vector<std::uint8_t>& marks, double left,
                   std::vector<double>& share) {
    for (std::size_t v = 0; v < share.size(); ++v) {
      if (!marks[v]) continue;
      share[v] *= left;
      if (share[v] < nothing) share[v] = 0;
    }
  }

  double largest(std::int32_t f, std::int32_t g, const std::vector<double>& share) const {
    double most = 0;
    for (const std::int32_t face : {f, g}) {
      for (const std::int32_t v : triangles_[face]) most = std::max(most, share[top_of(v)]);
    }
    return most;
  }

  /// Makes the shares of a site one, and lets them grow away from it no faster than they may.
  /// `growth(h)`: how much larger it may be at one end of h than at the other.
  template <class Growth>
  void spread(std::vector<double>& share, Growth growth) const {
    const auto& site_of = motion_.sites.site_of;
    for (bool changed = true; changed;) {
      changed = false;
      std::vector<double> of_site(motion_.sites.vertex.size(), 1);
      for (std::size_t v = 0; v < share.size(); ++v) {
        if (site_of[v] >= 0) of_site[site_of[v]] = std::min(of_site[site_of[v]], share[v]);
      }
      for (std::size_t v = 0; v < share.size(); ++v) {
        if (site_of[v] >= 0) share[v] = of_site[site_of[v]];
      }
      for (std::int32_t h = 0; h < 3 * mesh_.face_count(); ++h) {
        double &a = share[mesh_.from(h)], &b = share[mesh_.to(h)];
        const double most = growth(h) * std::max(std::min(a, b), nothing);
        if (std::max(a, b) <= most) continue;
        (a > b ? a : b) = most;
        changed = true;
      }
    }
  }

  std::vector<std::int32_t> folded(const std::vector<Vec3>& positions) const {
    std::vector<std::int32_t> faces;
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
      const Triangle& t = mesh_.triangle(f);
      bool turned = area_normal(mesh_.positions(), t).dot(area_normal(positions, t)) < 0;
      // A piece that has shrunk through its middle is turned about it, in its own plane.
      for (std::int32_t h = 3 * f; h < 3 * f + 3 && !turned; ++h) {
        turned = edge(mesh_.positions(), h).dot(edge(positions, h)) < 0;
      }
      if (turned) faces.push_back(f);
    }
    return faces;
  }

  Pairs crossings(const std::vector<Vec3>& positions) {
    Pairs pairs = self_intersections(positions, triangles_, most_pairs_, context_);
    if (pairs.empty()) return pairs;
    if (!knows_before_) {
      before_ = self_intersections(mesh_.positions(), mesh_.triangles(), most_pairs_, context_);
      knows_before_ = true;
    }
    Pairs fresh;
    std::set_difference(pairs.begin(), pairs.end(), before_.begin(), before_.end(),
                        std::back_inserter(fresh));
    return fresh;
  }

  Vec3 edge(const std::vector<Vec3>& positions, std::int32_t h) const {
    return positions[mesh_.to(h)] - positions[mesh_.from(h)];
  }
  bool has_wall(std::size_t v) const {
    return !motion_.walls.bottom.empty() && mesh_.is_open_vertex(static_cast<std::int32_t>(v));
  }
  std::int32_t top_of(std::int32_t v) const {
    return v < mesh_.vertex_count() ? v : motion_.walls.vertex[v - mesh_.vertex_count()];
  }

  const OpeningMotion& motion_;
  const TriangleMesh& mesh_;
  const Context& context_;
  std::vector<Triangle> triangles_;  // of the mesh, then of the walls
  OpeningShares shares_;
  std::vector<double> taper_;  // 3 #F: how much larger a share of the way may be at the other end
  std::size_t most_pairs_;
  Pairs before_;  // crossings of the mesh as it is
  bool knows_before_ = false;
};

}  // namespace

std::vector<Vec3> OpeningMotion::positions(const OpeningShares& shares) const {
  std::vector<Vec3> moved = mesh.positions();
  for (std::size_t v = 0; v < moved.size(); ++v) moved[v] += shares.move[v] * shift[v];
  for (std::size_t i = 0; i < walls.bottom.size(); ++i) {
    const Vec3& top = mesh.position(walls.vertex[i]);
    moved.push_back(top + shares.depth[walls.vertex[i]] * (walls.bottom[i] - top));
  }
  return moved;
}

OpeningLimit limit_opening(const OpeningMotion& motion, const Context& context) {
  return Limiter(motion, context).run();
}

}  // namespace craze
