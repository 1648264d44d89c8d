// One face, cut along every segment that passes through it, in one go.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "craze/engine/asset/face_grid.h"
#include "craze/surface_mesh.h"

namespace craze {

/// A straight piece of a curve between two points of a face; also a triangle's edge that lies on
/// one. label ≥ 0 names the curve.
struct FaceSegment {
  std::int32_t a, b;
  std::int32_t label;
};

/// What lies in a face. No two points before the inner ones are equal.
struct FaceDrawing {
  /// The three corners, (0, 0), (grid, 0), (0, grid); then the points inside edges 0, 1 and 2, each
  /// edge's in its direction; then those inside the face.
  std::vector<GridPoint> points;
  std::array<std::int32_t, 3> on_edge{};  ///< how many points are inside each edge
  std::vector<FaceSegment> segments;      ///< between any two points
  /// e₁·e₁, e₁·e₂, e₂·e₂ of the edges from corner 0 to corners 1 and 2: what a good triangle is.
  std::array<double, 3> metric{1, 0.5, 1};
  /// Points nearer to each other than this are one, and a segment that passes a point so near goes
  /// through it; grid units, ≥ 1.
  std::int32_t tolerance = 1 << 10;
};

/// Constrained Delaunay triangulation after Sloan (A fast algorithm for generating constrained
/// Delaunay triangulations, 1993) with exact predicates: every triangle is counter-clockwise with
/// an area above zero in the grid, and together they are the face. Where segments cross they share
/// a new point, rounded to the grid, and bend there by at most the tolerance. No point is added to
/// the face's edges. Expected O(n log n) where neighbouring points follow each other.
///
/// One object triangulates one face after the other and keeps its memory.
class FaceTriangulator {
 public:
  void run(const FaceDrawing& drawing);

  /// The drawing's points, then those where segments cross.
  const std::vector<GridPoint>& points() const { return points_; }
  /// For each point of the drawing the one that stands for it: itself, or an earlier one.
  const std::vector<std::int32_t>& same_as() const { return same_as_; }
  std::int32_t triangle_count() const { return static_cast<std::int32_t>(from_.size() / 3); }
  Triangle triangle(std::int32_t t) const {
    return {from_[3 * t], from_[3 * t + 1], from_[3 * t + 2]};
  }
  /// The edges of triangles that lie on segments, each once, with the lowest label among theirs.
  const std::vector<FaceSegment>& lines() const { return lines_; }
  /// Segments that could not be drawn in full: none was ever seen.
  std::int32_t lost() const { return lost_; }

 private:
  enum class Meets { edge_exists, nothing, point, line };
  struct Obstacle {
    Meets kind;
    std::int32_t at;  // the existing edge, the point or the line's halfedge
  };
  static constexpr std::int32_t free_edge = -2, border_edge = -1;

  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t prev(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::int32_t to(std::int32_t h) const { return from_[next(h)]; }
  std::int32_t apex(std::int32_t h) const { return from_[prev(h)]; }
  std::int64_t side(std::int32_t a, std::int32_t b, std::int32_t c) const {
    return orient(points_[a], points_[b], points_[c]);
  }
  template <class Visit>
  void for_each_outgoing(std::int32_t v, Visit&& visit) const;
  std::int32_t find(std::int32_t a, std::int32_t b) const;

  void link(std::int32_t h, std::int32_t o);
  std::int32_t split_edge(std::int32_t h, std::int32_t p);
  void split_triangle(std::int32_t t, std::int32_t p);
  void flip(std::int32_t h);
  bool is_convex(std::int32_t h) const;
  bool wants_flip(std::int32_t h) const;
  void legalize();
  void legalize_around(std::int32_t v);

  void add_border_points(const FaceDrawing& drawing);
  void add_inner_point(std::int32_t p);
  std::int32_t locate(const GridPoint& p) const;
  bool is_near(const GridPoint& a, const GridPoint& b) const;
  bool passes_near(std::int32_t p, std::int32_t q, std::int32_t c) const;

  void draw(const FaceSegment& segment);
  Obstacle first_obstacle(std::int32_t p, std::int32_t q);
  void force_edge(std::int32_t p, std::int32_t q);
  void mark(std::int32_t h, std::int32_t label);
  void cross_line(std::int32_t h, std::int32_t p, std::int32_t q);
  bool lead_through(std::int32_t v, std::int32_t h);

  std::vector<GridPoint> points_;
  std::vector<std::int32_t> same_as_;
  std::vector<std::int32_t> from_;      // 3 #T
  std::vector<std::int32_t> opposite_;  // 3 #T; −1 on the face's edges
  std::vector<std::int32_t> label_;     // 3 #T; the same on both sides of an edge
  std::vector<std::int32_t> start_;     // per point a halfedge that leaves it
  std::vector<std::int32_t> suspects_;  // edges that may have to flip
  std::vector<std::pair<std::int32_t, std::int32_t>> crossed_;  // edges in the way, by their ends
  std::vector<std::pair<std::int32_t, std::int32_t>> pending_;  // parts of a segment still to draw
  std::vector<FaceSegment> lines_;
  std::array<double, 3> metric_{};
  std::int64_t tolerance_ = 1;
  std::int32_t hint_ = 0;  // a triangle near the point added last
  std::int32_t lost_ = 0;
};

}  // namespace craze
