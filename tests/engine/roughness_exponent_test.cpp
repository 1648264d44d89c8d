// The exponent of post.roughness, measured: by the profile and by the lines that come out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "craze/engine.h"
#include "craze/engine/cracked_surface.h"
#include "craze/engine/roughness/crack_chains.h"
#include "craze/engine/roughness/self_affine_profile.h"
#include "mud_run.h"

namespace craze {
namespace {

using test::mud_run;
using test::plate;

std::string number(double x) {
  return std::to_string(x);
}

/// Sums of squared differences of the heights of lines over a chord, by lag.
class StructureFunction {
 public:
  /// lag: over the length of the chord.
  explicit StructureFunction(std::vector<double> lags)
      : lags_(std::move(lags)), sum_(lags_.size(), 0), count_(lags_.size(), 0) {}

  /// Points from end to end of one line, which runs nearly straight in the plane.
  void add(const std::vector<Vec3>& line) {
    const Vec3 chord = line.back() - line.front();
    const Vec3 across = Vec3::UnitZ().cross(chord) / chord.norm();
    std::vector<std::pair<double, double>> heights;  // by place on the chord
    for (const Vec3& p : line) {
      heights.emplace_back((p - line.front()).dot(chord) / chord.squaredNorm(),
                           (p - line.front()).dot(across));
    }
    std::sort(heights.begin(), heights.end());
    const auto height = [&](double x) {
      const auto after =
          std::upper_bound(heights.begin() + 1, heights.end() - 1, std::pair<double, double>{x, 0});
      const auto before = after - 1;
      const double step = after->first - before->first;
      return step > 0
                 ? before->second + (x - before->first) / step * (after->second - before->second)
                 : before->second;
    };
    for (std::size_t k = 0; k < lags_.size(); ++k) {
      for (double x = 0; x + lags_[k] <= 1; x += lags_[k] / 4) {
        const double difference = height(x + lags_[k]) - height(x);
        sum_[k] += difference * difference;
        ++count_[k];
      }
    }
  }

  double rms(std::size_t k) const { return std::sqrt(sum_[k] / count_[k]); }

  /// The slope of log rms against log lag, by least squares.
  double exponent() const {
    double x = 0, y = 0, xx = 0, xy = 0;
    const auto n = static_cast<double>(lags_.size());
    for (std::size_t k = 0; k < lags_.size(); ++k) {
      const double a = std::log(lags_[k]), b = std::log(rms(k));
      x += a / n;
      y += b / n;
      xx += a * a / n;
      xy += a * b / n;
    }
    return (xy - x * y) / (xx - x * x);
  }

 private:
  std::vector<double> lags_, sum_, count_;
};

/// From low to high, even in the logarithm.
std::vector<double> lags(double low, double high) {
  constexpr int count = 9;
  std::vector<double> result;
  for (int k = 0; k < count; ++k) {
    result.push_back(low * std::pow(high / low, static_cast<double>(k) / (count - 1)));
  }
  return result;
}

/// The lines between junctions that are at least so long, as points.
std::vector<std::vector<Vec3>> long_lines(const Result& result, double length) {
  const CrackNetwork& network = result.state().network;
  std::vector<std::vector<Vec3>> lines;
  for (const CrackChain& chain : crack_chains(network)) {
    const Vec3 chord = network.way(chain.nodes.front(), chain.nodes.back());
    if (chord.norm() < length) continue;
    std::vector<Vec3>& line = lines.emplace_back();
    for (const std::int32_t n : chain.nodes) line.push_back(network.nodes[n].position);
  }
  return lines;
}

TEST(SelfAffineProfile, HasTheMeanSquareDifferencesOfItsExponent) {
  for (const double exponent : {0.05, 0.3, 0.5, 0.75, 0.9, 0.97}) {
    for (const std::size_t lag : {1u, 8u, 64u}) {
      double sum = 0, count = 0;
      for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const std::vector<double> h = self_affine_profile(10, exponent, Random(seed));
        ASSERT_EQ(h.size(), 1025u);
        ASSERT_EQ(h.front(), 0);
        ASSERT_EQ(h.back(), 0);
        for (std::size_t i = 0; i + lag < h.size(); ++i) {
          sum += (h[i + lag] - h[i]) * (h[i + lag] - h[i]);
          ++count;
        }
      }
      const double expected = std::pow(static_cast<double>(lag) / 1024, exponent);
      EXPECT_NEAR(std::sqrt(sum / count) / expected, 1, 0.06) << exponent << " " << lag;
    }
  }
}

TEST(SelfAffineProfile, KeepsItsSlowWavesWhereItGetsFiner) {
  const std::vector<double> coarse = self_affine_profile(8, 0.75, Random(3)),
                            fine = self_affine_profile(12, 0.75, Random(3));
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_NEAR(coarse[i], fine[16 * i], 4 * std::pow(1.0 / 256, 0.75));
  }
}

TEST(RoughnessExponent, OfTheLinesIsTheOneAskedForOverTwoDecades) {
  // As much as leaves the lines flatter than 45 degrees, and above what they wind by themselves.
  for (const auto& [exponent, amplitude] : {std::pair{0.5, 0.02}, {0.75, 0.05}, {0.9, 0.05}}) {
    StructureFunction all(lags(0.001, 0.1));
    for (const int seed : {1, 2, 3, 4}) {
      // Tension along one axis: cracks from side to side, alongside each other.
      const Result result = mud_run(
          plate, {"stress.uniform=0", "stress.tensor=[1, 0, 0, 0, 0, 0]", "layer.spacing=0.2",
                  "seed=" + std::to_string(seed), "post.roughness=" + number(amplitude),
                  "post.roughness_step=0.0003", "post.roughness_exponent=" + number(exponent)});
      for (const std::vector<Vec3>& line : long_lines(result, 0.9)) all.add(line);
    }
    EXPECT_NEAR(all.exponent(), exponent, 0.05);
  }
}

}  // namespace
}  // namespace craze
