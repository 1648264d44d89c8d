// The vertices of a primitive whose triangles have been cut.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "craze/tensor.h"

namespace craze {

/// Where a vertex lies among those of its primitive: weights of up to three, those in use first, by
/// ascending vertex, sum 1. One alone has exactly 1.
struct VertexBlend {
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::array<std::uint32_t, 3> from{none, none, none};
  Vec3 weights = Vec3::Zero();

  bool is_copy() const { return from[1] == none; }
  int size() const { return from[1] == none ? 1 : from[2] == none ? 2 : 3; }
  /// The one with the largest weight.
  std::uint32_t nearest() const;
};

VertexBlend make_blend(const std::array<std::uint32_t, 3>& triangle, const Vec3& weights);

/// The vertices that a primitive had keep their numbers, each for the first vertex of the cut mesh
/// that asks for it; another side of a crack through it gets a copy, and other points vertices of
/// their own, after them. So nothing parts but where the cut mesh parts, and what a seam parted
/// stays parted.
class CutVertices {
 public:
  struct Vertex {
    VertexBlend blend;
    std::int32_t of = -1;  ///< the cut mesh's vertex
  };

  explicit CutVertices(std::size_t count) : owner_(count, -1) {}

  /// The number of the vertex that is `of` of the cut mesh at `blend`.
  std::uint32_t number(const VertexBlend& blend, std::int32_t of);

  std::size_t count() const { return owner_.size() + added_.size(); }
  /// #old: the cut mesh's vertex, −1 where no face of it came by.
  const std::vector<std::int32_t>& owner() const { return owner_; }
  const std::vector<Vertex>& added() const { return added_; }

 private:
  std::vector<std::int32_t> owner_;
  std::vector<Vertex> added_;
  std::map<std::pair<std::int32_t, std::array<std::uint32_t, 3>>, std::uint32_t> numbers_;
};

}  // namespace craze
