#include "craze/products/chips/chipped_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "craze/mesh/closest_point.h"

namespace craze {

namespace {

/// Edges in a chip, over how far it goes into the piece.
constexpr double fineness = 0.8;
constexpr int most_splits = 2000;  // for one chip
constexpr int most_steps = 10000;  // over faces to its middle
constexpr std::size_t chips_between_polls = 256;

/// Where a chip lies in space.
struct ChipFrame {
  Vec3 middle, x, y;

  Vec2 flat(const Vec3& p) const {
    const Vec3 d = p - middle;
    return {d.dot(x), d.dot(y)};
  }
};

class Chipper {
 public:
  Chipper(TriangleMesh mesh, const std::vector<MapCrack>& cracks, const Chips& chips,
          const Context& context)
      : mesh_(std::move(mesh)), cracks_(cracks), chips_(chips), context_(context) {
    sides_ = sides_of_cracks(cracks, mesh_);
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> by_roots;
    const auto ends = [&](std::int32_t h) {
      return std::pair{mesh_.root(mesh_.from(h)), mesh_.root(mesh_.to(h))};
    };
    for (std::int32_t h = 0; h < 3 * mesh_.face_count(); ++h) {
      if (mesh_.crack_of(h) >= 0) by_roots.emplace(ends(h), h);
    }
    mate_.assign(3 * mesh_.triangles().size(), -1);
    for (const auto& [roots, h] : by_roots) {
      const auto other = by_roots.find({roots.second, roots.first});
      if (other != by_roots.end()) mate_[h] = other->second;
    }
  }

  ChippedMesh run() {
    for_each([&](const Chip& chip, const ChipFrame& frame, std::int32_t face) {
      refine(chip, frame, face);
    });
    std::vector<double> depth(mesh_.positions().size(), 0);
    for_each([&](const Chip& chip, const ChipFrame& frame, std::int32_t face) {
      spread(chip, frame, face, [&](std::int32_t f) {
        for (const std::int32_t v : mesh_.triangle(f)) {
          depth[v] = std::max(depth[v], chip.depth_at(frame.flat(mesh_.position(v))));
        }
      });
    });
    return {std::make_shared<const TriangleMesh>(std::move(mesh_)), std::move(depth)};
  }

 private:
  /// Calls visit(chip, frame, face) with the face at its middle.
  template <class Visit>
  void for_each(Visit&& visit) {
    for (std::size_t i = 0; i < chips_.chips.size(); ++i) {
      if (i % chips_between_polls == 0) context_.check();
      const Chip& chip = chips_.chips[i];
      const std::int32_t side = sides_[chip.crack][chip.left ? 0 : 1].halfedge;
      if (side < 0) continue;
      std::int32_t face = TriangleMesh::face_of(side);
      const Vec3 &a = cracks_[chip.crack].a, &b = cracks_[chip.crack].b;
      ChipFrame frame;
      frame.x = (b - a).stableNormalized();
      frame.middle = a + chip.along * frame.x;
      face = face_at(frame.middle, face);
      const Vec3 normal = normal_of(face);
      frame.y = chip.left ? normal.cross(frame.x) : frame.x.cross(normal);
      visit(chip, frame, face);
    }
  }

  Vec3 normal_of(std::int32_t f) const {
    const Triangle& t = mesh_.triangle(f);
    return mesh_.way(t[0], t[1]).cross(mesh_.way(t[0], t[2])).stableNormalized();
  }
  Vec3 nearest_to(const Vec3& p, std::int32_t f) const {
    const Triangle& t = mesh_.triangle(f);
    const Vec3 &a = mesh_.position(t[0]), &b = mesh_.position(t[1]), &c = mesh_.position(t[2]);
    const Vec3 w = nearest_weights(p, a, b, c);
    return w[0] * a + w[1] * b + w[2] * c;
  }
  double edge(std::int32_t h) const { return mesh_.way(mesh_.from(h), mesh_.to(h)).norm(); }
  std::int32_t longest(std::int32_t f) const {
    std::int32_t best = 3 * f;
    for (const std::int32_t h : {3 * f + 1, 3 * f + 2}) {
      if (edge(h) > edge(best)) best = h;
    }
    return best;
  }

  /// Downhill over the faces that hang together, since the one that was there may be split by now.
  std::int32_t face_at(const Vec3& p, std::int32_t face) const {
    double distance = (nearest_to(p, face) - p).squaredNorm();
    for (int step = 0; step < most_steps; ++step) {
      std::int32_t better = -1;
      for (std::int32_t h = 3 * face; h < 3 * face + 3; ++h) {
        if (mesh_.is_open(h)) continue;
        const std::int32_t g = TriangleMesh::face_of(mesh_.opposite(h));
        const double d = (nearest_to(p, g) - p).squaredNorm();
        if (d >= distance) continue;
        distance = d;
        better = g;
      }
      if (better < 0) break;
      face = better;
    }
    return face;
  }

  bool touches(const Chip& chip, const ChipFrame& frame, std::int32_t f) const {
    const Vec3 p = nearest_to(frame.middle, f);
    const double reach = std::max(chip.reach, chip.inwards);
    return (p - frame.middle).squaredNorm() < reach * reach && chip.outline(frame.flat(p)) < 1;
  }

  /// Calls visit(f) for the faces that the chip touches, and which hang together.
  template <class Visit>
  void spread(const Chip& chip, const ChipFrame& frame, std::int32_t face, Visit&& visit) {
    std::vector<std::int32_t> stack{face}, seen;
    if (stamp_.size() < mesh_.triangles().size()) stamp_.resize(mesh_.triangles().size(), 0);
    ++now_;
    while (!stack.empty()) {
      const std::int32_t f = stack.back();
      stack.pop_back();
      if (stamp_[f] == now_) continue;
      stamp_[f] = now_;
      if (!touches(chip, frame, f)) continue;
      visit(f);
      if (stamp_.size() < mesh_.triangles().size()) stamp_.resize(mesh_.triangles().size(), 0);
      for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
        if (!mesh_.is_open(h)) stack.push_back(TriangleMesh::face_of(mesh_.opposite(h)));
      }
    }
  }

  void refine(const Chip& chip, const ChipFrame& frame, std::int32_t face) {
    const double most = fineness * std::min(chip.reach, chip.inwards);
    int left = most_splits;
    spread(chip, frame, face, [&](std::int32_t f) {
      while (left > 0 && edge(longest(f)) > most && touches(chip, frame, f)) {
        split_longest(f);
        --left;
      }
    });
  }

  /// Splits an edge that is the longest of both its faces, of f or of what lies on the way to one:
  /// so triangles stay as round as they were (Rivara, 1984).
  void split_longest(std::int32_t f) {
    for (;;) {
      const std::int32_t h = longest(f);
      if (!mesh_.is_open(h)) {
        const std::int32_t g = TriangleMesh::face_of(mesh_.opposite(h));
        if (edge(longest(g)) > edge(h)) {
          f = g;
          continue;
        }
      }
      split(h);
      return;
    }
  }

  void split(std::int32_t h) {
    const std::int32_t mate = mate_[h];
    const std::int32_t rest = halve(h);
    if (mate < 0) return;
    const std::int32_t rest_of_mate = halve(mate);
    mate_[h] = rest_of_mate;
    mate_[rest_of_mate] = h;
    mate_[rest] = mate;
    mate_[mate] = rest;
  }

  /// The second half; h is the first.
  std::int32_t halve(std::int32_t h) {
    const TriangleMesh::Split made = mesh_.split_edge(h, 0.5);
    mate_.resize(3 * mesh_.triangles().size(), -1);
    // The other sides of the faces keep their mates, of which one moved to each new half.
    for (int i = 0; i < 2; ++i) {
      if (made.new_face[i] < 0) continue;
      const std::int32_t moved = 3 * made.new_face[i] + 1;
      const std::int32_t old = mesh_.opposite(3 * made.new_face[i] + 2);
      mate_[moved] = mate_[old];
      if (mate_[moved] >= 0) mate_[mate_[moved]] = moved;
      mate_[old] = -1;
    }
    return 3 * made.new_face[0];
  }

  TriangleMesh mesh_;
  const std::vector<MapCrack>& cracks_;
  const Chips& chips_;
  const Context& context_;
  std::vector<std::array<CrackSide, 2>> sides_;
  std::vector<std::int32_t> mate_;   // per halfedge: the same edge on the crack's other side
  std::vector<std::int32_t> stamp_;  // per face: the last chip that came by
  std::int32_t now_ = 0;
};

}  // namespace

ChippedMesh chipped_mesh(TriangleMesh mesh, const std::vector<MapCrack>& cracks, const Chips& chips,
                         const Context& context) {
  return Chipper(std::move(mesh), cracks, chips, context).run();
}

}  // namespace craze
