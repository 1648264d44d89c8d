// How far the face of a crack lies aside of where it would be flat: self-affine in space.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "craze/model/sources/correlated_noise.h"
#include "craze/tensor.h"

namespace craze {

struct FaceFieldOptions {
  double amplitude = 0;   ///< length, > 0: rms difference of two points at the distance `usual`
  double usual = 1;       ///< length, > 0
  double exponent = 0.8;  ///< Hurst's, in (0, 1)
  double depth = 1;       ///< of the faces, length, > 0
  double step = 1;        ///< between points, length, > 0
  std::uint64_t seed = 0;
};

/// A random function of position whose differences are amplitude (r/usual)^exponent rms over the
/// distance r, from about a step to a tenth of the depth, and farther less: waves far longer than
/// the depth are slopes, which faces that are tied to both their edges have not. Octaves of
/// correlated noise.
class FaceField {
 public:
  explicit FaceField(const FaceFieldOptions& options);

  /// What values near each other share; for one thread at a time.
  class Memory {
   private:
    friend class FaceField;
    std::vector<CorrelatedNoise::Impulses> of_octave;
    CorrelatedNoise::Impulses of_arc;
  };

  double at(const Vec3& p, Memory& memory) const;

  /// Half a wave over the depth has this height in the middle, where a face is tied to both its
  /// edges: it stands for the differences between the two, which a tied face has not, and has their
  /// mean square slope.
  double arc(const Vec3& p, Memory& memory) const;

 private:
  std::vector<CorrelatedNoise> octaves_;
  std::vector<double> strengths_;
  CorrelatedNoise arc_;
  double arc_height_;
};

}  // namespace craze
