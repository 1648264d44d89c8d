#include "craze/products/distance/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "craze/base/random.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/mesh/repair/weld.h"

namespace craze {

namespace {

/// How far two sides may lie apart, relative to their length: files round to single precision.
constexpr double apart = 1e-5;
/// How far the places of one vertex in several objects may, relative to the mesh's size.
constexpr double same_place = 2.5e-7;
/// Of the halfedges with the same ends, so many are looked at for one that goes with another.
constexpr std::size_t most_choices = 16;

/// A stretch of a border halfedge between two places.
struct Stretch {
  std::int32_t from, to;  // vertices that stand for their places
  std::int32_t side;

  std::pair<std::int32_t, std::int32_t> ends() const { return {from, to}; }
  std::pair<std::int32_t, std::int32_t> reversed() const { return {to, from}; }
};

/// Stretches by the cells of a grid that they pass.
class StretchGrid {
 public:
  StretchGrid(const TriangleMesh& mesh, const std::vector<Stretch>& stretches)
      : mesh_(mesh), stretches_(stretches) {
    double total = 0;
    for (const Stretch& s : stretches) total += vector(s).norm();
    size_ = stretches.empty() ? 1 : std::max(total / static_cast<double>(stretches.size()), 1e-300);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const Vec3& a = mesh.position(stretches[i].from);
      const Vec3 d = vector(stretches[i]);
      // Half a cell per step, so that with its neighbours no cell on the way is missed.
      const int steps = 1 + static_cast<int>(std::min(2 * d.norm() / size_, 1e6));
      for (int s = 0; s <= steps; ++s) {
        auto& cell = cells_[key(index(a + d * s / steps))];
        if (cell.empty() || cell.back() != i) cell.push_back(i);
      }
    }
  }

  /// Calls visit(i) for the stretches that the point lies on and that run against `direction`.
  template <class Visit>
  void for_each_on(const Vec3& point, const Vec3& direction, Visit&& visit) const {
    const std::array<std::int64_t, 3> at = index(point);
    for (std::int64_t i = -1; i <= 1; ++i) {
      for (std::int64_t j = -1; j <= 1; ++j) {
        for (std::int64_t k = -1; k <= 1; ++k) {
          const auto cell = cells_.find(key({at[0] + i, at[1] + j, at[2] + k}));
          if (cell == cells_.end()) continue;
          for (const std::size_t s : cell->second) {
            if (holds(stretches_[s], point, direction)) visit(s);
          }
        }
      }
    }
  }

 private:
  Vec3 vector(const Stretch& s) const { return mesh_.position(s.to) - mesh_.position(s.from); }
  std::array<std::int64_t, 3> index(const Vec3& p) const {
    const auto cell = [&](double x) { return static_cast<std::int64_t>(std::floor(x / size_)); };
    return {cell(p.x()), cell(p.y()), cell(p.z())};
  }
  static std::uint64_t key(const std::array<std::int64_t, 3>& i) {
    return hash_bits(
        static_cast<std::uint64_t>(i[0]) ^
        hash_bits(static_cast<std::uint64_t>(i[1]) ^ hash_bits(static_cast<std::uint64_t>(i[2]))));
  }
  bool holds(const Stretch& s, const Vec3& point, const Vec3& direction) const {
    const Vec3 a = mesh_.position(s.from), d = vector(s);
    const double length = d.norm();
    if (length == 0 || d.dot(direction) > -0.999 * length) return false;
    const double along = (point - a).dot(d) / length;
    return along > 0 && along < length && (point - a - along / length * d).norm() <= apart * length;
  }

  const TriangleMesh& mesh_;
  const std::vector<Stretch>& stretches_;
  double size_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

/// The border halfedges, each vertex replaced by one that stands for all at its place.
std::vector<Stretch> border_stretches(const TriangleMesh& mesh) {
  std::vector<Stretch> stretches;
  std::vector<std::int32_t> vertices, number(mesh.vertex_count(), -1);
  std::vector<Vec3> positions;
  const auto note = [&](std::int32_t v) {
    if (number[v] >= 0) return;
    number[v] = static_cast<std::int32_t>(vertices.size());
    vertices.push_back(v);
    positions.push_back(mesh.position(v));
  };
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.opposite(h) != TriangleMesh::border) continue;
    note(mesh.from(h));
    note(mesh.to(h));
    stretches.push_back({mesh.from(h), mesh.to(h), h});
  }
  const std::vector<std::int32_t> first =
      weld(positions, same_place * bounding_diagonal(mesh.positions()));
  for (Stretch& s : stretches) {
    s.from = vertices[first[number[s.from]]];
    s.to = vertices[first[number[s.to]]];
  }
  stretches.erase(std::remove_if(stretches.begin(), stretches.end(),
                                 [](const Stretch& s) { return s.from == s.to; }),
                  stretches.end());
  return stretches;
}

/// Pairs stretches with the same ends, those that go together first, and takes them away.
void take_pairs(std::vector<Stretch>& stretches, const GoTogether& go_together, bool whole,
                std::vector<SeamPiece>& pieces) {
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& s, const Stretch& t) {
    return std::tie(s.from, s.to, s.side) < std::tie(t.from, t.to, t.side);
  });
  std::vector<char> taken(stretches.size(), 0);
  const auto begin_of = [&](std::pair<std::int32_t, std::int32_t> ends) {
    return static_cast<std::size_t>(
        std::lower_bound(stretches.begin(), stretches.end(), ends,
                         [](const Stretch& s, const auto& e) { return s.ends() < e; }) -
        stretches.begin());
  };
  const auto pair = [&](std::size_t i, std::size_t j) {
    taken[i] = taken[j] = 1;
    const bool first = stretches[i].side < stretches[j].side;
    const Stretch &s = stretches[first ? i : j], &t = stretches[first ? j : i];
    pieces.push_back({s.side, t.side, s.from, s.to, whole});
  };
  const auto pair_group = [&](std::size_t i, std::size_t end, const GoTogether* wanted) {
    std::size_t other = begin_of(stretches[i].reversed());
    const auto is_back = [&](std::size_t j) {
      return j < stretches.size() && stretches[j].ends() == stretches[i].reversed();
    };
    for (std::size_t s = i; s < end; ++s) {
      if (taken[s]) continue;
      while (is_back(other) && taken[other]) ++other;
      std::size_t looked = 0;
      for (std::size_t j = other; is_back(j) && looked < most_choices; ++j) {
        if (taken[j]) continue;
        ++looked;
        if (wanted && !(*wanted)(stretches[s].side, stretches[j].side)) continue;
        pair(s, j);
        break;
      }
    }
  };
  for (std::size_t i = 0; i < stretches.size();) {
    std::size_t end = i + 1;
    while (end < stretches.size() && stretches[end].ends() == stretches[i].ends()) ++end;
    if (stretches[i].from < stretches[i].to) {
      if (go_together) pair_group(i, end, &go_together);
      pair_group(i, end, nullptr);
    }
    i = end;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    if (!taken[i]) stretches[kept++] = stretches[i];
  }
  stretches.resize(kept);
}

/// The stretches, cut where the ends of others lie on them.
std::vector<Stretch> split_at_ends(const TriangleMesh& mesh, const std::vector<Stretch>& whole) {
  const StretchGrid grid(mesh, whole);
  std::vector<std::vector<std::int32_t>> inside(whole.size());
  for (const Stretch& s : whole) {
    const Vec3 direction = (mesh.position(s.to) - mesh.position(s.from)).normalized();
    for (const std::int32_t v : {s.from, s.to}) {
      grid.for_each_on(mesh.position(v), direction, [&](std::size_t i) {
        if (v != whole[i].from && v != whole[i].to) inside[i].push_back(v);
      });
    }
  }
  std::vector<Stretch> parts;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const Vec3& a = mesh.position(whole[i].from);
    const Vec3 d = mesh.position(whole[i].to) - a;
    std::vector<std::pair<double, std::int32_t>> at;
    for (const std::int32_t v : inside[i]) at.emplace_back((mesh.position(v) - a).dot(d), v);
    std::sort(at.begin(), at.end());
    std::int32_t from = whole[i].from;
    for (const auto& [along, v] : at) {
      if (v == from) continue;
      parts.push_back({from, v, whole[i].side});
      from = v;
    }
    parts.push_back({from, whole[i].to, whole[i].side});
  }
  return parts;
}

}  // namespace

std::vector<SeamPiece> seam_pieces(const TriangleMesh& mesh, const GoTogether& go_together) {
  std::vector<SeamPiece> pieces;
  std::vector<Stretch> stretches = border_stretches(mesh);
  take_pairs(stretches, go_together, true, pieces);
  std::vector<Stretch> parts = split_at_ends(mesh, stretches);
  take_pairs(parts, {}, false, pieces);
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const SeamPiece& p, const SeamPiece& q) { return p.side < q.side; });
  return pieces;
}

std::vector<std::int32_t> seam_sides(const TriangleMesh& mesh) {
  std::vector<std::int32_t> sides;
  for (const SeamPiece& piece : seam_pieces(mesh)) {
    sides.insert(sides.end(), {piece.side, piece.other});
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

}  // namespace craze
