#include "craze/mesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <tuple>

#include "craze/base/error.h"
#include "craze/base/parallel.h"
#include "craze/base/random.h"
#include "craze/mesh/closest_point.h"
#include "craze/mesh/edge_length_field.h"
#include "craze/mesh/edit_mesh.h"
#include "craze/mesh/feature_lines.h"
#include "craze/mesh/remesh_transfer.h"
#include "craze/mesh/triangle_mesh.h"

namespace craze {

namespace {

constexpr std::size_t grain = 512;
constexpr double too_long = 4.0 / 3, too_short = 4.0 / 5;  // of the length wanted
// Lengths between the two thresholds come out a little shorter than wanted: measured on flat and
// round shapes, their mean is 1/1.055 of it.
constexpr double centre_of_band = 1.055;
constexpr double variation = 0.15;       // of the length wanted, seeded
constexpr double shake = 0.3;            // of that length: the first round's random displacement
constexpr double seam_tolerance = 1e-6;  // of that length: how straight a seam is to be thinned
constexpr double shortest_to_halve =
    0.4;  // of that length: where the middle is no point of the input
constexpr double most_faces = 50e6;

Vec3 cross_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a);
}

class Remesher {
 public:
  Remesher(const SurfaceMesh& input, const TriangleMesh& topology, const RemeshOptions& options,
           const Context& context)
      : input_(input),
        options_(options),
        context_(context),
        variation_(options.seed, 1),
        place_(options.seed, 2),
        shaking_(options.seed, 3),
        max_distance_(options.max_distance > 0 ? options.max_distance : 0.1 * options.target_edge),
        lengths_(edge_length_field(topology, options.target_edge, options.coarsen)),
        marks_(without_short_creases(
            topology, feature_lines(input, topology, options.feature_angle), lengths_)),
        patch_(patches(topology.face_count(), marks_, seam,
                       [&](std::int32_t h) { return topology.opposite(h); })),
        tree_(input_.positions, input_.triangles, patch_),
        mesh_(input.positions, input.triangles, marks_) {
    refuse_too_many(topology);
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      add_vertex(lengths_[v], mesh_.is_vertex(v) ? topology.first_halfedge(v) / 3 : -1);
    }
  }

  SurfaceMesh run() {
    for (int round = 0; round < options_.iterations && !context_.is_cancelled(); ++round) {
      context_.report({"prepare", static_cast<double>(round) / (options_.iterations + 1)});
      split_long_edges();
      collapse_short_edges();
      flip_edges();
      smooth(round == 0 ? shake : 0);
      flip_edges();
    }
    if (!context_.is_cancelled()) {
      pull_vertices();
      approach_input();
    }
    return transfer_attributes({input_, patch_, tree_}, mesh_, context_.threads);
  }

 private:
  void refuse_too_many(const TriangleMesh& topology) const {
    double faces = 0;
    for (std::int32_t f = 0; f < topology.face_count(); ++f) {
      double length = 0;
      for (std::int32_t v : topology.triangle(f)) length += lengths_[v] / 3;
      faces += topology.area(f) / (std::sqrt(3.0) / 4 * length * length);
    }
    if (faces <= most_faces) return;
    throw Error(ErrorKind::request, "simulation mesh too fine",
                "target edge " + std::to_string(options_.target_edge),
                "it would have about " + std::to_string(std::llround(faces / 1e6)) +
                    " million triangles; ask for a longer edge");
  }

  void add_vertex(double length, std::int32_t near_face) {
    const double u = variation_.uniform_at(wanted_.size());
    length_.push_back(length);
    wanted_.push_back(centre_of_band * length * (1 + variation * (2 * u - 1)));
    near_.push_back(near_face);
    line_error_.push_back(0);
  }

  double edge_length(std::int32_t h) const {
    return (mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h))).norm();
  }
  double wanted(std::int32_t v, std::int32_t w) const { return 0.5 * (wanted_[v] + wanted_[w]); }
  Vec3 face_cross(std::int32_t f) const {
    const Triangle& t = mesh_.triangle(f);
    return cross_of(mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2]));
  }

  std::int32_t split(std::int32_t h, const Vec3& at) {
    const std::int32_t a = mesh_.from(h), b = mesh_.to(h);
    const std::int32_t x = mesh_.split(h, at);
    add_vertex(0.5 * (length_[a] + length_[b]), near_[a]);
    line_error_.back() = std::max(line_error_[a], line_error_[b]);
    return x;
  }

  struct LongEdge {
    double ratio;  // of its length to the one wanted
    std::int32_t h, from, to;
    bool operator<(const LongEdge& o) const { return std::tie(ratio, h) < std::tie(o.ratio, o.h); }
  };

  LongEdge measure(std::int32_t h) const {
    const std::int32_t a = mesh_.from(h), b = mesh_.to(h);
    return {edge_length(h) / wanted(a, b), h, a, b};
  }

  // Splits the longest edges first and flips whenever the longest have come down by a third: coarse
  // faces then fall into well-shaped ones.
  void split_long_edges() {
    while (!context_.is_cancelled()) {
      std::vector<LongEdge> edges;
      double longest = 0;
      for (std::int32_t h = 0; h < mesh_.halfedge_slots(); ++h) {
        if (!mesh_.is_edge(h)) continue;
        const LongEdge e = measure(h);
        longest = std::max(longest, e.ratio);
        if (e.ratio > too_long) edges.push_back(e);
      }
      if (edges.empty()) return;
      const double limit = std::max(too_long, longest / 1.5);
      std::priority_queue<LongEdge> queue;
      const auto add = [&](const LongEdge& e) {
        if (e.ratio > limit) queue.push(e);
      };
      std::for_each(edges.begin(), edges.end(), add);
      while (!queue.empty()) {
        const LongEdge e = queue.top();
        queue.pop();
        if (mesh_.from(e.h) != e.from || mesh_.to(e.h) != e.to) continue;  // split or moved since
        const double t = 0.5 + 0.16 * (place_.uniform() - 0.5);
        const std::int32_t x =
            split(e.h, (1 - t) * mesh_.position(e.from) + t * mesh_.position(e.to));
        mesh_.for_each_outgoing(x, [&](std::int32_t h) {
          for (std::int32_t g = 3 * (h / 3); g < 3 * (h / 3) + 3; ++g) add(measure(g));
        });
      }
      flip_edges();
    }
  }

  void collapse_short_edges() {
    for (std::int32_t h = 0; h < mesh_.halfedge_slots(); ++h) {
      if (!mesh_.is_edge(h)) continue;
      if (edge_length(h) >= too_short * wanted(mesh_.from(h), mesh_.to(h))) continue;
      const std::int32_t o = mesh_.opposite(h);
      if (may_collapse(h)) {
        collapse(h);
      } else if (o >= 0 && may_collapse(o)) {
        collapse(o);
      }
    }
  }

  void collapse(std::int32_t h) {
    const std::int32_t a = mesh_.from(h), b = mesh_.to(h);
    if (mesh_.mark(h) != no_feature) {
      line_error_[b] = std::max(line_error_[a], line_error_[b]) + distance_to_new_line(h);
    }
    mesh_.collapse(h);
  }

  // How far the vertex that goes lies from the line between its two neighbours on a marked line.
  double distance_to_new_line(std::int32_t h) const {
    const std::int32_t a = mesh_.from(h), b = mesh_.to(h);
    std::int32_t other = -1;
    mesh_.for_each_outgoing(a, [&](std::int32_t g) {
      if (mesh_.mark(g) != no_feature && mesh_.to(g) != b) other = mesh_.to(g);
      const std::int32_t p = EditMesh::prev(g);
      if (mesh_.opposite(p) < 0 && mesh_.mark(p) != no_feature) other = mesh_.from(p);
    });
    const Vec3 &p = mesh_.position(a), &q = mesh_.position(b), &r = mesh_.position(other);
    const Vec3 w = nearest_weights(p, q, r, r);
    return (w[0] * q + (1 - w[0]) * r - p).norm();
  }

  bool may_collapse(std::int32_t h) const {
    if (!mesh_.can_collapse(h)) return false;
    const std::int32_t a = mesh_.from(h), b = mesh_.to(h);
    if (mesh_.mark(h) != no_feature) {
      const double off = distance_to_new_line(h);
      if (mesh_.mark(h) == seam && off > seam_tolerance * wanted_[a]) return false;
      if (std::max(line_error_[a], line_error_[b]) + off > max_distance_ / 4) return false;
    }
    // The faces that stay must not fold, stretch or leave the vertex far outside.
    bool good = true;
    double nearest = mesh_.count_marked(a) > 0 ? 0 : 2 * max_distance_;
    mesh_.for_each_outgoing(a, [&](std::int32_t g) {
      const std::int32_t c = mesh_.to(g), d = mesh_.apex(g);
      if (!good || c == b || d == b) return;
      const Vec3 &pb = mesh_.position(b), &pc = mesh_.position(c), &pd = mesh_.position(d);
      const Vec3 before = face_cross(g / 3), after = cross_of(pb, pc, pd);
      if (!(after.dot(before) > 0.7 * after.norm() * before.norm()) ||
          (pc - pb).norm() > too_long * wanted(b, c) ||
          (pd - pb).norm() > too_long * wanted(b, d) ||
          after.norm() < 0.1 * (pc - pd).squaredNorm()) {
        good = false;
        return;
      }
      const Vec3 w = nearest_weights(mesh_.position(a), pb, pc, pd);
      nearest = std::min(nearest, (w[0] * pb + w[1] * pc + w[2] * pd - mesh_.position(a)).norm());
    });
    return good && nearest <= max_distance_ / 2;
  }

  // A few sweeps of Lawson flips: in the plane they end in the Delaunay triangulation.
  void flip_edges() {
    for (int sweep = 0, flips = 1; sweep < 12 && flips > 0; ++sweep) {
      flips = 0;
      for (std::int32_t h = 0; h < mesh_.halfedge_slots(); ++h) {
        if (!mesh_.is_edge(h) || !wants_flip(h)) continue;
        mesh_.flip(h);
        ++flips;
      }
    }
  }

  bool wants_flip(std::int32_t h) const {
    const std::int32_t o = mesh_.opposite(h);
    if (o < 0 || mesh_.mark(h) != no_feature) return false;
    const Vec3 &a = mesh_.position(mesh_.from(h)), &b = mesh_.position(mesh_.to(h));
    const Vec3 &c = mesh_.position(mesh_.apex(h)), &d = mesh_.position(mesh_.apex(o));
    const Vec3 above = (a - c).cross(b - c), below = (b - d).cross(a - d);
    const double area_c = above.norm(), area_d = below.norm();
    // cot γ + cot δ < 0: the two angles opposite the edge sum to more than a straight one.
    if ((a - c).dot(b - c) * area_d + (a - d).dot(b - d) * area_c >= -1e-9 * area_c * area_d) {
      return false;
    }
    const Vec3 left = cross_of(c, a, d), right = cross_of(d, b, c), side = above + below;
    const double least = 0.5 * side.norm();
    if (!(left.dot(side) > least * left.norm()) || !(right.dot(side) > least * right.norm())) {
      return false;
    }
    // The gap between the two diagonals is what the flip moves the surface by.
    const Vec3 axis = (b - a).cross(d - c);
    if (std::abs((c - a).dot(axis)) > 0.5 * max_distance_ * axis.norm()) return false;
    return mesh_.can_flip(h);
  }

  struct Move {
    bool wanted = false;
    Vec3 to;
    std::int32_t face = -1;
    double length = 0;
  };

  // Moves each free vertex to the centre of its star, within the tangent plane, and back onto the
  // input. All targets are found first, so that they do not depend on threads.
  void smooth(double shaken) {
    std::vector<Move> moves(mesh_.vertex_count());
    parallel_for(context_.threads, moves.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        moves[v] = find_move(static_cast<std::int32_t>(v), shaken);
      }
    });
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      const Move& m = moves[v];
      if (!m.wanted) continue;
      // A part of the way where all of it would fold the star.
      const Vec3 from = mesh_.position(v);
      for (const double part : {1.0, 0.5, 0.25}) {
        const Vec3 to = from + part * (m.to - from);
        if (!keeps_star(v, to, 0.5)) continue;
        mesh_.move(v, to);
        near_[v] = m.face;
        wanted_[v] *= m.length / length_[v];
        length_[v] = m.length;
        break;
      }
    }
  }

  Move find_move(std::int32_t v, double shaken) const {
    Move move;
    if (!mesh_.is_vertex(v) || mesh_.count_marked(v) > 0) return move;
    const Vec3 p = mesh_.position(v);
    Vec3 normal = Vec3::Zero(), center = Vec3::Zero();
    double weight = 0;
    mesh_.for_each_outgoing(v, [&](std::int32_t h) {
      const Vec3 cross = face_cross(h / 3);
      const std::int32_t b = mesh_.to(h), c = mesh_.apex(h);
      const double l = (wanted_[v] + wanted_[b] + wanted_[c]) / 3, w = cross.norm() / (l * l);
      normal += cross;
      center += w / 3 * (p + mesh_.position(b) + mesh_.position(c));
      weight += w;
    });
    if (!(normal.norm() > 0)) return move;
    normal.normalize();
    Vec3 step = center / weight - p;
    for (int axis = 0; axis < 3 && shaken > 0; ++axis) {
      step[axis] += shaken * wanted_[v] * (2 * shaking_.uniform_at(3ull * v + axis) - 1);
    }
    step -= step.dot(normal) * normal;
    const ClosestPoint::Hit hit = tree_.find(p + step, {normal, -1, near_[v]});
    if (hit.face < 0) return move;
    move.wanted = true;
    move.to = hit.point;
    move.face = hit.face;
    for (int i = 0; i < 3; ++i) {
      move.length += hit.weights[i] * lengths_[input_.triangles[hit.face][i]];
    }
    return move;
  }

  // least: the cosine of the largest turn of a face.
  bool keeps_star(std::int32_t v, const Vec3& to, double least) const {
    bool keeps = true;
    mesh_.for_each_outgoing(v, [&](std::int32_t h) {
      const Vec3 &b = mesh_.position(mesh_.to(h)), &c = mesh_.position(mesh_.apex(h));
      const Vec3 before = face_cross(h / 3), after = cross_of(to, b, c);
      keeps = keeps && after.dot(before) > least * after.norm() * before.norm() &&
              after.norm() >= std::min(0.2 * (b - c).squaredNorm(), before.norm());
    });
    return keeps;
  }

  // Puts the free vertices that smoothing left beside the input back onto it. Returns those that
  // moved.
  std::vector<std::int32_t> pull_vertices() {
    std::vector<Move> moves(mesh_.vertex_count());
    const double enough = 1e-3 * max_distance_;
    parallel_for(context_.threads, moves.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto v = static_cast<std::int32_t>(i);
        if (!mesh_.is_vertex(v) || mesh_.count_marked(v) > 0) continue;
        const auto hit = tree_.find(mesh_.position(v), {Vec3::Zero(), -1, near_[v], enough});
        moves[v].to = hit.point;
        moves[v].face = hit.face;
        moves[v].wanted = hit.distance > enough;
      }
    });
    std::vector<std::int32_t> moved;
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(moves.size()); ++v) {
      if (moves[v].face >= 0) near_[v] = moves[v].face;
      if (!moves[v].wanted || !keeps_star(v, moves[v].to, 0.1)) continue;
      mesh_.move(v, moves[v].to);
      moved.push_back(v);
    }
    return moved;
  }

  // Splits faces whose middle, or that of an edge, lies too far from the input.
  void approach_input() {
    const int rounds = 10;
    std::vector<Triangle> sound;  // the corners of a slot's face when it was last found near enough
    for (int round = 0; round < rounds && !context_.is_cancelled(); ++round) {
      sound.resize(mesh_.face_slots(), {-1, -1, -1});
      std::vector<std::int32_t> to_split(sound.size(), -1);
      parallel_for(context_.threads, sound.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin; slot < end; ++slot) {
          const auto f = static_cast<std::int32_t>(slot);
          if (sound[f] == mesh_.triangle(f)) continue;
          if (is_near(f)) {
            sound[f] = mesh_.triangle(f);
          } else {
            to_split[f] = longest_free_side(f);
          }
        }
      });
      bool again = false;
      std::vector<char> touched(sound.size(), 0);  // its sides are no longer those looked at
      for (const std::int32_t h : to_split) {
        if (h < 0) continue;
        again = true;
        const std::int32_t o = mesh_.opposite(h);  // a free edge has two sides
        const bool beside_new = 3 * touched.size() <= static_cast<std::size_t>(o);
        if (beside_new || touched[h / 3] || touched[o / 3]) continue;
        touched[h / 3] = touched[o / 3] = 1;
        const Vec3 nearest = tree_.find(middle_of(h), near(h)).point;
        if (suits_split(h, nearest)) {
          split(h, nearest);
        } else if (edge_length(h) > shortest_to_halve * wanted(mesh_.from(h), mesh_.to(h))) {
          split(h, middle_of(h));
        } else {
          sound[h / 3] = mesh_.triangle(h / 3);  // a fold that more vertices would not open
        }
      }
      if (!again) return;
      flip_edges();
      for (const std::int32_t v : pull_vertices()) {
        mesh_.for_each_outgoing(v, [&](std::int32_t h) {
          if (static_cast<std::size_t>(h / 3) < sound.size()) sound[h / 3] = {-1, -1, -1};
        });
      }
    }
  }

  // True if the four faces that a vertex at p makes of the two beside h stand as these do.
  bool suits_split(std::int32_t h, const Vec3& p) const {
    for (const std::int32_t g : {h, mesh_.opposite(h)}) {
      const Vec3 &a = mesh_.position(mesh_.from(g)), &b = mesh_.position(mesh_.to(g));
      const Vec3& c = mesh_.position(mesh_.apex(g));
      const Vec3 whole = cross_of(a, b, c);
      for (const Vec3& part : {cross_of(a, p, c), cross_of(p, b, c)}) {
        if (!(part.dot(whole) > 0.1 * part.norm() * whole.norm()) ||
            part.norm() < 0.05 * whole.norm()) {
          return false;
        }
      }
    }
    return true;
  }

  Vec3 middle_of(std::int32_t h) const {
    return 0.5 * (mesh_.position(mesh_.from(h)) + mesh_.position(mesh_.to(h)));
  }
  ClosestPoint::Filter near(std::int32_t h) const {
    return {Vec3::Zero(), -1, near_[mesh_.from(h)]};
  }

  bool is_near(std::int32_t f) const {
    const auto within = [&](const Vec3& p, std::int32_t h) {
      ClosestPoint::Filter filter = near(h);
      filter.enough = max_distance_;
      return tree_.find(p, filter).distance <= max_distance_;
    };
    const Triangle& t = mesh_.triangle(f);
    const Vec3 sum = mesh_.position(t[0]) + mesh_.position(t[1]) + mesh_.position(t[2]);
    if (!within(sum / 3, 3 * f)) return false;
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh_.is_edge(h) && mesh_.mark(h) == no_feature && !within(middle_of(h), h)) return false;
    }
    return true;
  }

  // −1 if all sides lie on kept lines.
  std::int32_t longest_free_side(std::int32_t f) const {
    std::int32_t longest = -1;
    double length = 0;
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh_.mark(h) != no_feature || edge_length(h) <= length) continue;
      length = edge_length(h);
      longest = h;
    }
    return longest;
  }

  const SurfaceMesh& input_;
  const RemeshOptions& options_;
  const Context& context_;
  Random variation_, place_, shaking_;  // independent streams of the seed
  double max_distance_;
  std::vector<double> lengths_;      // #V of the input: the length wanted there
  std::vector<char> marks_;          // 3 #F of the input
  std::vector<std::int32_t> patch_;  // #F of the input
  ClosestPoint tree_;                // of the input
  EditMesh mesh_;
  std::vector<double> length_;      // #V: that length at the vertex,
  std::vector<double> wanted_;      // and with its random variation
  std::vector<std::int32_t> near_;  // #V: an input face near the vertex
  std::vector<double> line_error_;  // #V: how far thinning may have moved its marked line
};

}  // namespace

SurfaceMesh remesh(const SurfaceMesh& input, const RemeshOptions& options, const Context& context) {
  if (!(options.target_edge > 0) || !std::isfinite(options.target_edge)) {
    throw Error(ErrorKind::request, "bad edge length", std::to_string(options.target_edge),
                "a positive number is needed");
  }
  const TriangleMesh topology(input.positions, input.triangles);
  if (topology.face_count() == 0) return input;
  return Remesher(input, topology, options, context).run();
}

}  // namespace craze
