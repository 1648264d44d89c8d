// Where a surface passes through itself.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "craze/context.h"
#include "craze/surface_mesh.h"

namespace craze {

/// The pairs of triangles (lower index first, ascending) that cross: an edge of one goes through
/// the inside of the other, by more than rounding. Triangles that share a corner, by index or by
/// place, cross where the opposite edge of one goes through the other or through its opposite edge;
/// those that share two do not.
/// Touching, and lying on each other in one plane, is no crossing. At most `limit` pairs. Throws
/// Cancelled.
std::vector<std::array<std::int32_t, 2>> self_intersections(const std::vector<Vec3>& positions,
                                                            const std::vector<Triangle>& triangles,
                                                            std::size_t limit = SIZE_MAX,
                                                            const Context& context = {});

/// The same for a surface that is asked about again and again as some of it moves: only pairs of
/// which one has moved since are looked at.
class SelfIntersections {
 public:
  using Pairs = std::vector<std::array<std::int32_t, 2>>;

  /// The triangles are not copied. Those before sheet_end that lie over each other in one plane,
  /// turned the same way, cross too, by more than rounding: as parts of one sheet.
  SelfIntersections(const std::vector<Triangle>& triangles, std::size_t limit,
                    std::int32_t sheet_end = 0);
  ~SelfIntersections();
  SelfIntersections(const SelfIntersections&) = delete;
  SelfIntersections& operator=(const SelfIntersections&) = delete;

  /// What self_intersections() says of these positions (#V, the same number each time); valid until
  /// the next call. Throws Cancelled; the next call then begins anew.
  const Pairs& at(const std::vector<Vec3>& positions, const Context& context);

  /// #V: what has moved between the last two calls; what may have, where all had to be looked at.
  const std::vector<char>& moved() const { return moved_; }

 private:
  class BoxTree;

  void find(bool all, const Context& context);

  const std::vector<Triangle>& triangles_;
  std::size_t limit_;
  std::int32_t sheet_end_;
  std::vector<Vec3> positions_;  // of the last call
  std::vector<char> moved_;      // #V: since the call before it
  std::unique_ptr<BoxTree> tree_;
  Pairs pairs_;  // as far as they have been found
};

}  // namespace craze
