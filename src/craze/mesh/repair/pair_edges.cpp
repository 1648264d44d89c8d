#include "craze/mesh/repair/pair_edges.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "craze/mesh/sorted_halfedges.h"

namespace craze {

namespace {

constexpr std::size_t most_faces_paired = 16;  // at one edge: the pairs tried grow as its square

std::int32_t next(std::int32_t h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}

// A part of the surface joined by paired edges.
struct Part {
  std::vector<std::int32_t> faces;
  std::int32_t flips = 0;  // after turning as the majority
  bool closed = true;
  double volume = 0;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

  bool holds(const Part& o) const {
    return (low.array() < o.low.array()).all() && (high.array() > o.high.array()).all();
  }
};

class Pairing {
 public:
  Pairing(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles)
      : positions_(positions), triangles_(triangles) {
    result_.opposite.assign(3 * triangles.size(), -1);
    result_.flipped.assign(triangles.size(), 0);
  }

  EdgePairs run() {
    pair_all();
    std::vector<Part> parts;
    std::vector<char> seen(triangles_.size(), 0);
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      if (!seen[f]) parts.push_back(flood(static_cast<std::int32_t>(f), seen));
    }
    for (Part& p : parts) measure(p);
    turn_outward(parts);
    renumber();
    return std::move(result_);
  }

 private:
  std::int32_t from(std::int32_t h) const { return triangles_[h / 3][h % 3]; }
  std::int32_t to(std::int32_t h) const { return from(next(h)); }
  bool same_direction(std::int32_t g, std::int32_t h) const { return from(g) == from(h); }

  void join(std::int32_t g, std::int32_t h) {
    result_.opposite[g] = h;
    result_.opposite[h] = g;
  }

  void pair_all() {
    const std::vector<std::int32_t> edges = sorted_halfedges(triangles_, positions_.size());
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
      const VertexPair edge = vertices_of(triangles_, edges[i]);
      for (j = i + 1; j < edges.size() && vertices_of(triangles_, edges[j]) == edge;) ++j;
      if (j - i == 2) join(edges[i], edges[i + 1]);
      if (j - i > 2) pair_crowd({edges.begin() + i, edges.begin() + j});
    }
  }

  void pair_crowd(const std::vector<std::int32_t>& sides) {
    ++result_.crowded_edges;
    if (sides.size() > most_faces_paired) {
      ++result_.cut_edges;
      return;
    }
    // The direction in which each face leaves the edge.
    const Vec3 a = positions_[std::min(from(sides[0]), to(sides[0]))];
    const Vec3 axis = (positions_[std::max(from(sides[0]), to(sides[0]))] - a).normalized();
    std::vector<Vec3> away;
    for (std::int32_t h : sides) {
      const Vec3 d = positions_[to(next(h))] - a;
      away.emplace_back((d - d.dot(axis) * axis).normalized());
    }
    join_walls(sides, axis, away);
    struct Candidate {
      bool same_direction;
      double cosine;  // −1: the faces continue each other flatly
      std::int32_t g, h;
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t j = i + 1; j < sides.size(); ++j) {
        candidates.push_back(
            {same_direction(sides[i], sides[j]), away[i].dot(away[j]), sides[i], sides[j]});
      }
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
      return std::tie(x.same_direction, x.cosine, x.g, x.h) <
             std::tie(y.same_direction, y.cosine, y.g, y.h);
    });
    for (const Candidate& c : candidates) {
      if (result_.opposite[c.g] < 0 && result_.opposite[c.h] < 0) join(c.g, c.h);
    }
    if (sides.size() % 2 == 1) ++result_.cut_edges;
  }

  // Where two faces have the same corners they are a wall: behind each lies a solid of its own, and
  // the face that closes it is the first one met by turning from the wall backwards.
  void join_walls(const std::vector<std::int32_t>& sides, const Vec3& axis,
                  const std::vector<Vec3>& away) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const std::int32_t g = sides[i];
      const auto is_twin = [&](std::int32_t h) {
        return to(next(h)) == to(next(g)) && !same_direction(g, h) && h != g;
      };
      if (result_.opposite[g] >= 0 || std::none_of(sides.begin(), sides.end(), is_twin)) continue;
      const Vec3 along = from(g) < to(g) ? axis : Vec3(-axis);
      const Vec3 back = away[i].cross(along);
      std::int32_t nearest = -1;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < sides.size(); ++j) {
        const std::int32_t h = sides[j];
        if (h == g || result_.opposite[h] >= 0 || same_direction(g, h) || is_twin(h)) continue;
        // Grows with the angle from 0 to a full turn.
        const double cosine = away[i].dot(away[j]);
        const double turn = back.dot(away[j]) >= 0 ? 1 - cosine : 3 + cosine;
        if (turn < least) {
          least = turn;
          nearest = h;
        }
      }
      if (nearest >= 0) join(g, nearest);
    }
  }

  // Orients everything reachable from `start` alike, as most of its faces stand.
  Part flood(std::int32_t start, std::vector<char>& seen) {
    Part part;
    auto& flipped = result_.flipped;
    part.faces.push_back(start);
    seen[start] = 1;
    for (std::size_t i = 0; i < part.faces.size(); ++i) {
      const std::int32_t f = part.faces[i];
      part.flips += flipped[f];
      for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::int32_t o = result_.opposite[h];
        if (o < 0) continue;
        const char wanted = static_cast<char>(flipped[f] ^ (same_direction(h, o) ? 1 : 0));
        if (!seen[o / 3]) {
          seen[o / 3] = 1;
          flipped[o / 3] = wanted;
          part.faces.push_back(o / 3);
        } else if (flipped[o / 3] != wanted) {
          result_.opposite[h] = result_.opposite[o] = -1;
          ++result_.cut_edges;
        }
      }
    }
    if (2 * static_cast<std::size_t>(part.flips) > part.faces.size()) flip(part);
    return part;
  }

  void flip(Part& part) {
    for (std::int32_t f : part.faces) result_.flipped[f] ^= 1;
    part.flips = static_cast<std::int32_t>(part.faces.size()) - part.flips;
    part.volume = -part.volume;
  }

  void measure(Part& part) const {
    const Vec3 origin = positions_[triangles_[part.faces[0]][0]];
    for (std::int32_t f : part.faces) {
      const Triangle& t = triangles_[f];
      Vec3 p[3];
      for (int i = 0; i < 3; ++i) {
        p[i] = positions_[t[i]];
        part.low = part.low.cwiseMin(p[i]);
        part.high = part.high.cwiseMax(p[i]);
        part.closed = part.closed && result_.opposite[3 * f + i] >= 0;
      }
      const double volume = (p[0] - origin).dot((p[1] - origin).cross(p[2] - origin)) / 6;
      part.volume += result_.flipped[f] ? -volume : volume;
    }
  }

  void turn_outward(std::vector<Part>& parts) {
    // Solids that may be hollow: the largest few are enough and keep this step linear.
    std::vector<const Part*> solids;
    for (const Part& p : parts) {
      if (p.closed && p.volume > 0) solids.push_back(&p);
    }
    std::stable_sort(solids.begin(), solids.end(),
                     [](const Part* a, const Part* b) { return a->volume > b->volume; });
    if (solids.size() > 64) solids.resize(64);
    std::vector<Part*> inverted;
    for (Part& p : parts) {
      if (!p.closed || p.volume >= 0) continue;
      const bool consistent = p.flips == 0;
      const bool inner = consistent && std::any_of(solids.begin(), solids.end(),
                                                   [&](const Part* s) { return s->holds(p); });
      if (!inner) inverted.push_back(&p);
    }
    for (Part* p : inverted) flip(*p);
    for (const Part& p : parts) result_.flips += p.flips;
  }

  // Exchanging corners 1 and 2 of a face exchanges its sides 0 and 2.
  void renumber() {
    const auto renamed = [&](std::int32_t h) {
      return h >= 0 && result_.flipped[h / 3] ? 3 * (h / 3) + 2 - h % 3 : h;
    };
    std::vector<std::int32_t> opposite(result_.opposite.size());
    for (std::size_t h = 0; h < opposite.size(); ++h) {
      opposite[renamed(static_cast<std::int32_t>(h))] = renamed(result_.opposite[h]);
    }
    result_.opposite = std::move(opposite);
  }

  const std::vector<Vec3>& positions_;
  const std::vector<Triangle>& triangles_;
  EdgePairs result_;
};

}  // namespace

EdgePairs pair_edges(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  return Pairing(positions, triangles).run();
}

}  // namespace craze
