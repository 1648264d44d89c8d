// Cracks of an earlier cycle: the layer is whole again, but weaker across where they ran.
//
// References
// Goehring, Conroy, Akhter, Clegg, Routh: Evolution of mud-crack patterns during repeated drying
// cycles. Soft Matter 6, 2010.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "craze/base/period.h"
#include "craze/base/symmetric_eigen.h"
#include "craze/tensor.h"

namespace craze {

/// The plane on which a node with healed cracks about it comes closest to failing.
struct WeakPlane {
  Eigenpair plane;      ///< n̂ and n̂ᵀ ς n̂
  double strength = 1;  ///< the factor on strength and toughness across it
  /// The greatest n̂ᵀ ς n̂ / strength changes by at most sensitivity / strength times a change of ς.
  double sensitivity = 1;
};

/// A straight piece of an old crack.
struct HealedPiece {
  Vec3 start, end;
  Vec3 up;  ///< along the surface's normal, of any length
};

/// Strength and toughness across a plane with unit normal n̂ are multiplied by n̂ᵀ W⁻² n̂, with
/// W = √r I + (1 − √r) Σ g n̂ᵢ n̂ᵢᵀ over the healed pieces of crack. n̂ᵢ is the piece's normal in the
/// surface, g the convolution of the piece with a normal law of deviation w, scaled to be 1 on a
/// long straight crack. So a plane along an old straight crack has the strength that the layer had
/// when it first cracked, one square to it or away from it 1/r of that, and where cracks met both
/// directions are weak.
class HealedCracks {
 public:
  HealedCracks() = default;
  /// ratio: r, 0 < r ≤ 1. width: w > 0, length.
  HealedCracks(std::span<const HealedPiece> pieces, double ratio, double width, Period period = {});

  bool empty() const { return pieces_.empty(); }
  /// W at a point.
  Mat3 weakness(const Vec3& position) const;
  /// Maximises n̂ᵀ ς n̂ over the factor n̂ᵀ W⁻² n̂ on the strength, W = weakness(position).
  WeakPlane weakest_plane(const Mat3& weakness, const Sym3& separation) const;

 private:
  struct Piece {
    Vec3 start, along, normal;  // along: unit
    double length;
  };
  using Cell = std::uint64_t;
  void add_weakness(const Vec3& position, Mat3& sum) const;
  Cell cell_of(const Vec3& p, int dx, int dy, int dz) const;

  Period period_;
  double root_ = 1, width_ = 0;  // √r, w
  double cell_size_ = 1;
  std::vector<Piece> pieces_;
  std::unordered_map<Cell, std::vector<std::int32_t>> cells_;  // by the cell of their middle
};

}  // namespace craze
