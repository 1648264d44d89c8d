#include "craze/model/failure/healed_cracks.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "craze/base/elementary.h"
#include "craze/base/random.h"

namespace craze {

namespace {

// A piece is felt up to this many deviations from it.
constexpr double reach = 6.5;
// From here on erf is 1 in double precision: such a piece adds nothing.
constexpr double erf_is_one = 6;
// Of the longest piece.
constexpr double least_width = 1e-9;

}  // namespace

HealedCracks::HealedCracks(std::span<const HealedPiece> pieces, double ratio, double width,
                           Period period)
    : period_(period), root_(std::sqrt(ratio)), width_(width) {
  assert(ratio > 0 && ratio <= 1 && width > 0);
  double longest = 0;
  for (const HealedPiece& piece : pieces) {
    const Vec3 d = piece.end - piece.start;
    const Vec3 normal = piece.up.cross(d);
    if (!(normal.norm() > 0)) continue;
    const Vec3 middle = piece.start + 0.5 * d;
    pieces_.push_back({piece.start + (period_.wrapped(middle) - middle), d.normalized(),
                       normal.normalized(), d.norm()});
    longest = std::max(longest, d.norm());
  }
  // Too narrow to be told from none.
  if (width_ < least_width * longest) pieces_.clear();
  cell_size_ = reach * width_ + longest / 2;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Vec3 middle = pieces_[i].start + 0.5 * pieces_[i].length * pieces_[i].along;
    cells_[cell_of(middle, 0, 0, 0)].push_back(static_cast<std::int32_t>(i));
  }
}

Mat3 HealedCracks::weakness(const Vec3& position) const {
  Mat3 sum = root_ * Mat3::Identity();
  period_.for_each_image(position, cell_size_,
                         [&](const Vec3& image) { add_weakness(image, sum); });
  return sum;
}

void HealedCracks::add_weakness(const Vec3& position, Mat3& sum) const {
  const double scale = 1 / (std::sqrt(2.0) * width_);
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        const auto cell = cells_.find(cell_of(position, dx, dy, dz));
        if (cell == cells_.end()) continue;
        for (const std::int32_t i : cell->second) {
          const Piece& p = pieces_[i];
          const Vec3 d = position - p.start;
          const double along = d.dot(p.along);
          const double across = (d.squaredNorm() - along * along) * scale * scale;
          const double from = scale * along, to = scale * (along - p.length);
          if (across > reach * reach / 2 || from < -erf_is_one || to > erf_is_one) continue;
          const double g =
              elementary::exp(-across) / 2 * (elementary::erf(from) - elementary::erf(to));
          sum += (1 - root_) * g * p.normal * p.normal.transpose();
        }
      }
    }
  }
}

WeakPlane HealedCracks::weakest_plane(const Mat3& w, const Sym3& separation) const {
  // With n̂ = W m / |W m| the ratio is mᵀ W ς W m / mᵀ m, so m is an eigenvector of W ς W.
  const Mat3 driven = w * separation.matrix() * w;
  const Eigenpair top = largest_eigenpair(
      {driven(0, 0), driven(1, 1), driven(2, 2), 0.5 * (driven(0, 1) + driven(1, 0)),
       0.5 * (driven(1, 2) + driven(2, 1)), 0.5 * (driven(2, 0) + driven(0, 2))});
  const Vec3 normal = w * top.vector;
  const double squared = normal.squaredNorm();
  const double norm = w.trace() - 2 * root_;  // no eigenvalue of W is greater, none less than √r
  return {{top.value / squared, normal / std::sqrt(squared)}, 1 / squared, norm * norm / squared};
}

HealedCracks::Cell HealedCracks::cell_of(const Vec3& p, int dx, int dy, int dz) const {
  const auto index = [&](double x, int d) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cell_size_)) + d);
  };
  return hash_bits(index(p.x(), dx) ^ hash_bits(index(p.y(), dy) ^ hash_bits(index(p.z(), dz))));
}

}  // namespace craze
