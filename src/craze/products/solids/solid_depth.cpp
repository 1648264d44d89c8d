#include "craze/products/solids/solid_depth.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "craze/mesh/self_intersection.h"
#include "craze/products/opening/spread_limit.h"
#include "craze/products/solids/room_inside.h"

namespace craze {

namespace {

using Pairs = SelfIntersections::Pairs;

constexpr int rounds = 40;
/// What is left of a depth after each round in which it was too much.
constexpr double step_back = 0.7;
/// How much deeper per length along the surface.
constexpr double growth = 1;

/// Faces whose height is a smaller share of their length have no side that could be turned.
constexpr double needle = 1e-5;

/// Of the mesh, then what makes it solid.
std::vector<Triangle> all_triangles(const SolidShape& shape) {
  std::vector<Triangle> triangles = shape.mesh.triangles();
  const std::vector<Triangle>& made = shape.topology.triangles;
  triangles.insert(triangles.end(), made.begin(), made.end());
  return triangles;
}

class DepthLimiter {
 public:
  DepthLimiter(const SolidShape& shape, double thickness, const Context& context)
      : shape_(shape),
        mesh_(shape.mesh),
        thickness_(thickness),
        context_(context),
        triangles_(all_triangles(shape)),
        crossings_(triangles_, 4 * triangles_.size()),
        whole_(shape.whole()),
        on_site_(shape.sites.vertex.size()) {
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (shape.sites.site_of[v] >= 0) on_site_[shape.sites.site_of[v]].push_back(v);
    }
  }

  SolidDepth run() {
    SolidDepth limit;
    limit.depth = room_inside(mesh_, shape_.outwards, thickness_, context_);
    for (int round = 0; round < rounds; ++round) {
      context_.report({"thicken", static_cast<double>(round) / rounds});
      context_.check();
      spread_limit(mesh_, shape_.sites, on_site_, thickness_, growth, 1, limit.depth);
      limit.crossings = step(limit.depth, limit.stuck);
      if (limit.crossings == 0) break;
    }
    context_.report({"thicken", 1});
    for (const double depth : limit.depth) {
      limit.limited += depth < thickness_ ? 1 : 0;
      limit.least = std::min(limit.least, depth / thickness_);
    }
    return limit;
  }

 private:
  /// Takes back where it is too deep (`less`, #V); how many pairs and faces said so.
  std::int32_t step(std::vector<double>& depth, std::vector<std::uint8_t>& less) {
    const std::vector<Vec3> positions = shape_.positions(depth);
    less.assign(depth.size(), 0);
    std::int32_t wrong = 0;
    const auto mark = [&](std::int32_t triangle) {
      for (const std::int32_t v : triangles_[triangle]) {
        if (v >= mesh_.vertex_count()) less[vertex_of(v)] = 1;
      }
    };
    for (std::int32_t t = inner_begin(); t < static_cast<std::int32_t>(triangles_.size()); ++t) {
      if (!is_turned(t, positions)) continue;
      mark(t);
      ++wrong;
    }
    for (const auto& [f, g] : fresh_crossings(positions)) {
      mark(f);
      mark(g);
      ++wrong;
    }
    for (std::size_t v = 0; v < depth.size(); ++v) {
      if (less[v]) depth[v] *= step_back;
    }
    return wrong;
  }

  std::int32_t inner_begin() const { return mesh_.face_count() + shape_.topology.inner_begin; }
  std::int32_t vertex_of(std::int32_t bottom) const {
    return shape_.topology.bottoms[bottom - mesh_.vertex_count()].vertex;
  }

  /// Whether the triangle below a face looks the other way than the face, or an edge of it points
  /// back; without chips, which an inner surface does not follow.
  bool is_turned(std::int32_t t, const std::vector<Vec3>& positions) const {
    const bool is_core = t >= mesh_.face_count() + shape_.topology.core_begin;
    const std::vector<Vec3>& tops = is_core ? mesh_.positions() : whole_;
    const Triangle& below = triangles_[t];
    std::array<Vec3, 3> top, bottom;
    for (std::size_t i = 0; i < 3; ++i) {
      const SolidBottom& b = shape_.topology.bottoms[below[i] - mesh_.vertex_count()];
      top[i] = tops[b.from] + b.share * (tops[b.to] - tops[b.from]);
      bottom[i] = positions[below[i]];
    }
    const Vec3 normal = (top[1] - top[0]).cross(top[2] - top[0]);
    const double facing = normal.dot((bottom[1] - bottom[0]).cross(bottom[2] - bottom[0]));
    double longest = 0;  // squared
    bool points_back = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      longest = std::max(longest, (top[j] - top[i]).squaredNorm());
      points_back = points_back || (top[j] - top[i]).dot(bottom[j] - bottom[i]) < 0;
    }
    return points_back || facing < -needle * needle * longest * longest;
  }

  /// What crosses with something made here, but not where the faces above do, nor of shells that
  /// pass through each other as they are.
  Pairs fresh_crossings(const std::vector<Vec3>& positions) {
    const Pairs& pairs = crossings_.at(positions, context_);
    Pairs above, pierced, fresh;
    for (const auto& [f, g] : pairs) {
      if (std::max(f, g) >= mesh_.face_count()) continue;
      above.push_back({f, g});
      if (shell_of(f) != shell_of(g)) pierced.push_back(ordered(shell_of(f), shell_of(g)));
    }
    std::sort(pierced.begin(), pierced.end());
    for (const auto& [f, g] : pairs) {
      if (std::max(f, g) < mesh_.face_count()) continue;
      const auto faces = ordered(beside(f), beside(g));
      const auto shells = ordered(shell_of(faces[0]), shell_of(faces[1]));
      if (std::binary_search(above.begin(), above.end(), faces) ||
          std::binary_search(pierced.begin(), pierced.end(), shells)) {
        continue;
      }
      fresh.push_back({f, g});
    }
    return fresh;
  }

  static std::array<std::int32_t, 2> ordered(std::int32_t a, std::int32_t b) {
    return {std::min(a, b), std::max(a, b)};
  }

  /// The face itself, or that which a triangle made here hangs from.
  std::int32_t beside(std::int32_t t) const {
    return t < mesh_.face_count() ? t : shape_.topology.beside[t - mesh_.face_count()];
  }
  std::int32_t shell_of(std::int32_t face) const {
    return shape_.shells.of_vertex[mesh_.triangle(face)[0]];
  }

  const SolidShape& shape_;
  const TriangleMesh& mesh_;
  double thickness_;
  const Context& context_;
  std::vector<Triangle> triangles_;
  SelfIntersections crossings_;                     // of triangles_
  std::vector<Vec3> whole_;                         // #V
  std::vector<std::vector<std::int32_t>> on_site_;  // the vertices of each site
};

}  // namespace

SolidDepth limit_depth(const SolidShape& shape, double thickness, const Context& context) {
  return DepthLimiter(shape, thickness, context).run();
}

}  // namespace craze
