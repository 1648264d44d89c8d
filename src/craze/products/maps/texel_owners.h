// Which piece of the surface each texel shows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "craze/products/maps/map_surface.h"
#include "craze/products/maps/uv_layout.h"

namespace craze {

/// Every texel belongs to the piece that its centre lies in, the first of them where several hold
/// it; one that no piece holds, to that of the nearest texel that has one. Pieces that share the
/// bits of an edge share no texel along it. A piece too small for a centre has the texel around its
/// middle where that is free.
class TexelOwners {
 public:
  /// Keeps nothing of what it is given. `size`: 1 … MapOptions::largest_size.
  TexelOwners(std::span<const MapPiece> pieces, std::span<const PlacedPiece> placed, int size);

  struct Owner {
    std::int32_t placed = -1;  ///< index into `placed`; −1: no texel of the picture is covered
    std::int32_t x, y;         ///< the covered texel whose owner it is: itself, or the nearest
  };

  /// Of the texels of row y, size of them.
  void row(int y, std::vector<Owner>& owners) const;

  std::int64_t covered() const { return covered_; }
  /// Texels that a further piece holds as well.
  std::int64_t overlapping() const { return overlapping_; }

 private:
  void find_nearest_in_columns();

  int size_;
  std::int64_t covered_ = 0, overlapping_ = 0;
  std::vector<std::int32_t> owner_;         // per texel; −1: none
  std::vector<std::uint16_t> nearest_row_;  // per texel: of the nearest covered one of its column
};

/// Corner i of a placed piece in texels: x to the right, y down, texel (0, 0) covering 0 … 1.
inline Vec2 in_texels(const Vec2& uv, const Vec2& offset, int size) {
  return {(uv.x() - offset.x()) * size, (1 - (uv.y() - offset.y())) * size};
}

}  // namespace craze
