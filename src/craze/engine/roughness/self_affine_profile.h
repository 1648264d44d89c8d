// Rough lines: self-affine profiles between two fixed ends.
#pragma once

#include <vector>

#include "craze/base/random.h"

namespace craze {

/// 2^k + 1 heights at even distances over a unit length, 0 at both ends. The mean square difference
/// of two of them at the distance r is r^{2 exponent}, exponent in (0, 1), up to r of about a
/// quarter: fractional Brownian motion, of which a fixed end leaves the slow part out, which one
/// arc over the whole length makes up for. k in 1 … 20. Of one `random` the slow waves are the same
/// whatever k, so that a finer profile follows a coarser one.
std::vector<double> self_affine_profile(int k, double exponent, const Random& random);

}  // namespace craze
