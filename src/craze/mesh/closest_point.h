// The nearest point of a surface, by a tree of boxes.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <vector>

#include "craze/surface_mesh.h"

namespace craze {

class ClosestPoint {
 public:
  struct Hit {
    std::int32_t face = -1;  ///< −1: no face passes the filter
    Vec3 weights;            ///< barycentric coordinates in the face, ≥ 0, sum 1
    Vec3 point;
    double distance;
  };

  /// Which faces may answer.
  struct Filter {
    Vec3 normal = Vec3::Zero();  ///< only faces that do not look away from it; zero: any
    std::int32_t label = -1;     ///< only faces of this label; −1: any
    std::int32_t hint = -1;      ///< a face that is likely near: makes the search shorter
    double enough = 0;           ///< any face within this distance will do
    double least = 0;            ///< cosine with a unit `normal` that a face must have
    /// Only faces nearer than this.
    double farthest = std::numeric_limits<double>::infinity();
  };

  /// labels: #F or empty. Keeps references: positions and triangles must outlive this.
  ClosestPoint(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
               std::vector<std::int32_t> labels = {});

  /// Ties go to whichever face the search meets first, the same one every time. Thread-safe.
  Hit find(const Vec3& point, const Filter& filter) const;
  Hit find(const Vec3& point) const { return find(point, Filter()); }

  const Vec3& normal(std::int32_t f) const { return normals_[f]; }
  /// True if the face may answer.
  bool accepts(std::int32_t f, const Filter& filter) const {
    return (filter.label < 0 || labels_[f] == filter.label) &&
           normals_[f].dot(filter.normal) >= filter.least;
  }
  /// Makes `best`, whose distance is squared, the nearest point of face f if that is nearer.
  void improve(Hit& best, std::int32_t f, const Vec3& point) const;

 private:
  struct Node {
    std::int32_t first, count;  // a leaf's faces in order_; count 0: children at first, first + 1
    Eigen::AlignedBox3d box{}, normals{};  // around its faces and their normals
  };

  void build();
  void fit();
  static bool may_accept(const Node& node, const Filter& filter);

  const std::vector<Vec3>& positions_;
  const std::vector<Triangle>& triangles_;
  std::vector<std::int32_t> labels_;
  std::vector<Vec3> normals_;
  std::vector<std::int32_t> order_;
  std::vector<Node> nodes_;
};

/// Barycentric coordinates of the point of triangle abc nearest to p (Ericson, Real-Time Collision
/// Detection, 2005, §5.1.5).
Vec3 nearest_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace craze
