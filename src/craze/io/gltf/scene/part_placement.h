// Between the scene's axes and those in which a primitive's vertices are given.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "craze/io/gltf/scene/blend_elements.h"
#include "craze/io/gltf/scene/gltf_document.h"

namespace craze {

/// How the vertices of a part are placed: all by its node, or each by its joints. Where a transform
/// has no inverse, what it flattens is left alone.
class PartPlacement {
 public:
  /// `joints`: of the part's skin. All must outlive this.
  PartPlacement(const GltfPart& part, const std::vector<Eigen::Matrix4d>& joints,
                const std::vector<JointSet>& sets);

  bool is_skinned() const { return !sets_.empty(); }
  /// A point of the scene in the axes of that vertex.
  Vec3 to_local(std::size_t vertex, const Vec3& point) const;
  /// A shift in the scene as a shift of that vertex.
  Vec3 shift_to_local(std::size_t vertex, const Vec3& shift) const;
  /// A normal of the scene in the axes of that vertex, unit.
  Vec3 normal_to_local(std::size_t vertex, const Vec3& normal) const;

 private:
  Eigen::Matrix4d matrix(std::size_t vertex) const;

  const Eigen::Matrix4d& transform_;
  const std::vector<Eigen::Matrix4d>& joints_;
  const std::vector<JointSet>& sets_;
};

}  // namespace craze
