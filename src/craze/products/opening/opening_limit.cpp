#include "craze/products/opening/opening_limit.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "craze/mesh/crossing/triangles_cross.h"
#include "craze/mesh/self_intersection.h"
#include "craze/products/opening/curl.h"
#include "craze/products/opening/spread_limit.h"
#include "craze/products/opening/turned_faces.h"

namespace craze {

namespace {

using Pairs = SelfIntersections::Pairs;

constexpr int rounds = 60;
/// What is left of a share after each of the first rounds in which it was too much; then nothing.
constexpr double step_back = 0.65;
constexpr int rounds_of_steps = 25;
/// Of the mean distance between cracks: over such a length a share grows from nothing to all.
constexpr double taper_per_spacing = 1.0 / 6;
/// Where all are made smaller, the length over which a share grows by what was begun with: half of
/// a piece, so that pieces shrink as a whole.
constexpr double smaller_taper_per_spacing = 1.0 / 2;
/// How far the rims of nearly all pieces may go then, of the mean distance between cracks.
constexpr double rim_way = 1.0 / 3, nearly_all = 0.9;
/// Shares below are nothing at all.
constexpr double nothing = 0.03;
/// Walls of this share of their depth are no deeper than need be.
constexpr double shallow = 0.1;

std::vector<Triangle> mesh_and_walls(const OpeningMotion& motion) {
  std::vector<Triangle> triangles = motion.mesh.triangles();
  triangles.insert(triangles.end(), motion.walls.triangles.begin(), motion.walls.triangles.end());
  return triangles;
}

class Limiter {
 public:
  Limiter(const OpeningMotion& motion, const Context& context)
      : motion_(motion),
        mesh_(motion.mesh),
        context_(context),
        triangles_(mesh_and_walls(motion)),
        most_pairs_(4 * triangles_.size()),
        crossings_(triangles_, most_pairs_, mesh_.face_count()) {
    shares_.move.assign(mesh_.vertex_count(), 1);
    shares_.depth.assign(mesh_.vertex_count(), 1);
    spacing_ = 3 * natural_curl_length(mesh_, motion.sites);
    on_site_.resize(motion.sites.vertex.size());
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (motion.sites.site_of[v] >= 0) on_site_[motion.sites.site_of[v]].push_back(v);
    }
  }

  OpeningLimit run() {
    bool sound = false;
    for (int round = 0; round < rounds && !sound; ++round) {
      context_.report({"open", static_cast<double>(round) / rounds});
      context_.check();
      spread(lowered_moves_, growth_, shares_.move);
      spread(lowered_depths_, 1 / taper_per_spacing, shares_.depth);
      sound = step(round < rounds_of_steps ? step_back : 0);
      if (round == 0 && !sound) begin_smaller();
    }
    if (sound) give_back_walls();
    context_.report({"open", 1});
    OpeningLimit limit;
    if (!sound) {
      const std::vector<Vec3> positions = motion_.positions(shares_);
      limit.folded = static_cast<std::int32_t>(turned_faces(mesh_, positions).size());
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
    const double way = ways[static_cast<std::size_t>(at)], most = rim_way * spacing_;
    if (!(way > most)) return;
    const double share = most / way;
    shares_.move.assign(shares_.move.size(), share);
    shares_.depth.assign(shares_.depth.size(), 1);
    growth_ = share / smaller_taper_per_spacing;
    lowered_moves_.clear();
    lowered_depths_.clear();
  }

  /// Takes back where it is too far; true where nothing is.
  bool step(double left) {
    const std::vector<Vec3> positions = motion_.positions(shares_);
    const Pairs pairs = crossings(positions);
    const std::vector<std::int32_t> turned = turned_at(positions);
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
    lowered_moves_ = take(less_move, left, shares_.move);
    lowered_depths_ = take(less_depth, left, shares_.depth);
    return turned.empty() && pairs.empty();
  }

  /// Walls that lost their depth before the movement that was too much for them was taken back are
  /// shallow where that leaves room for them.
  void give_back_walls() {
    std::vector<std::uint8_t> given(shares_.depth.size(), 0);
    for (const std::int32_t v : motion_.walls.vertex) {
      given[v] = shares_.depth[v] == 0;
      if (given[v]) set_depth(v, shallow);
    }
    bool sound = std::find(given.begin(), given.end(), 1) == given.end();
    for (int round = 0; !sound; ++round) {
      context_.check();
      const Pairs pairs = crossings(motion_.positions(shares_));
      sound = pairs.empty() || round == rounds;
      for (const auto& [f, g] : pairs) {
        for (const std::int32_t face : {f, g}) {
          for (const std::int32_t v : triangles_[face]) {
            if (v >= mesh_.vertex_count() && given[top_of(v)]) set_depth(top_of(v), 0);
          }
        }
      }
      if (round < rounds) continue;
      for (const std::int32_t v : motion_.walls.vertex) {
        if (given[v]) set_depth(v, 0);
      }
    }
  }

  /// On all of a vertex's site.
  void set_depth(std::int32_t v, double share) {
    shares_.depth[v] = share;
    if (motion_.sites.site_of[v] < 0) return;
    for (const std::int32_t u : on_site_[motion_.sites.site_of[v]]) shares_.depth[u] = share;
  }

  /// turned_faces(), asked again only of what moved for the last crossings().
  std::vector<std::int32_t> turned_at(const std::vector<Vec3>& positions) {
    const std::vector<char>& moved = crossings_.moved();
    is_turned_.resize(mesh_.triangles().size());
    std::vector<std::int32_t> turned;
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
      const auto& [a, b, c] = mesh_.triangle(f);
      if (moved[a] || moved[b] || moved[c]) is_turned_[f] = is_turned(mesh_, positions, f) ? 1 : 0;
      if (is_turned_[f]) turned.push_back(f);
    }
    return turned;
  }

  void mark(std::int32_t face, std::vector<std::uint8_t>& marks) const {
    for (const std::int32_t v : triangles_[face]) marks[top_of(v)] = 1;
  }

  /// What was lowered.
  static std::vector<std::int32_t> take(const std::vector<std::uint8_t>& marks, double left,
                                        std::vector<double>& share) {
    std::vector<std::int32_t> lowered;
    for (std::size_t v = 0; v < share.size(); ++v) {
      if (!marks[v]) continue;
      lowered.push_back(static_cast<std::int32_t>(v));
      share[v] *= left;
      if (share[v] < nothing) share[v] = 0;
    }
    return lowered;
  }

  double largest(std::int32_t f, std::int32_t g, const std::vector<double>& share) const {
    double most = 0;
    for (const std::int32_t face : {f, g}) {
      for (const std::int32_t v : triangles_[face]) most = std::max(most, share[top_of(v)]);
    }
    return most;
  }

  /// No share grows faster along the surface than over the taper.
  void spread(const std::vector<std::int32_t>& lowered, double growth,
              std::vector<double>& share) const {
    if (spacing_ == 0) return;  // no cracks
    spread_limit_from(mesh_, motion_.sites, on_site_, lowered, growth, spacing_, share);
  }

  Pairs crossings(const std::vector<Vec3>& positions) {
    const Pairs& pairs = crossings_.at(positions, context_);
    Pairs fresh;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(fresh), [&](const auto& pair) {
      return !crossed_before(pair[0], pair[1]) && !is_pierced(pair[0], pair[1]);
    });
    return fresh;
  }

  bool crossed_before(std::int32_t f, std::int32_t g) const {
    return std::max(f, g) < mesh_.face_count() &&
           triangles_cross(mesh_.positions(), mesh_.triangle(f), mesh_.triangle(g), true);
  }

  /// The parts of the mesh with its cracks shut.
  void find_shells() {
    shell_.resize(mesh_.vertex_count());
    std::iota(shell_.begin(), shell_.end(), 0);
    const auto find = [&](std::int32_t v) {
      while (shell_[v] != v) v = shell_[v] = shell_[shell_[v]];
      return v;
    };
    for (const Triangle& t : mesh_.triangles()) {
      for (const int i : {1, 2}) {
        const std::int32_t a = find(mesh_.root(t[0])), b = find(mesh_.root(t[i]));
        shell_[std::max(a, b)] = std::min(a, b);
      }
    }
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) shell_[v] = find(mesh_.root(v));
  }

  /// Which shells pass through which others as they are: where they do so moves as they open.
  void find_pierced() {
    const Pairs before = SelfIntersections(mesh_.triangles(), most_pairs_, mesh_.face_count())
                             .at(mesh_.positions(), context_);
    for (const auto& [f, g] : before) pierced_.push_back(shells_of(f, g));
    std::sort(pierced_.begin(), pierced_.end());
    knows_pierced_ = true;
  }

  bool is_pierced(std::int32_t f, std::int32_t g) {
    if (shell_.empty()) find_shells();
    if (shell_of(f) == shell_of(g)) return false;
    if (!knows_pierced_) find_pierced();
    return std::binary_search(pierced_.begin(), pierced_.end(), shells_of(f, g));
  }

  /// The face itself, or that which a wall hangs from.
  std::int32_t beside(std::int32_t f) const {
    return f < mesh_.face_count() ? f : motion_.walls.beside[f - mesh_.face_count()];
  }
  std::int32_t shell_of(std::int32_t f) const { return shell_[mesh_.triangle(beside(f))[0]]; }

  std::pair<std::int32_t, std::int32_t> shells_of(std::int32_t f, std::int32_t g) const {
    const std::int32_t a = shell_of(f), b = shell_of(g);
    return {std::min(a, b), std::max(a, b)};
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
  std::size_t most_pairs_;
  SelfIntersections crossings_;                     // of triangles_
  std::vector<std::vector<std::int32_t>> on_site_;  // the vertices of each site
  double spacing_ = 0;                              // mean distance between cracks
  double growth_ = 1 / taper_per_spacing;           // of a share of the way, over such a distance
  OpeningShares shares_;
  std::vector<std::int32_t> lowered_moves_, lowered_depths_;    // by the last step
  std::vector<char> is_turned_;                                 // #F, at the last step
  std::vector<std::int32_t> shell_;                             // #V; empty: not asked for
  std::vector<std::pair<std::int32_t, std::int32_t>> pierced_;  // shells, ascending
  bool knows_pierced_ = false;
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
