#include "craze/products/chips/chips.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <unordered_map>
#include <utility>

#include "craze/base/elementary.h"
#include "craze/base/random.h"
#include "craze/base/text/format.h"
#include "craze/engine/width_by_age.h"

namespace craze {

namespace {

constexpr double ln4 = 1.3862943611198906;
/// The largest reach over the mean distance between cracks: by itself, and at most.
constexpr double usual_size = 1.0 / 8, most_size = 1.0 / 3;
/// A chip is no larger than so many times half the width of the crack there.
constexpr double most_per_half_width = 12;
constexpr double most_share = 0.98;
constexpr double last_to_open = 0.35;  // chips per length, over the first
constexpr double at_junction = 2;      // and over those away from junctions
constexpr double junction_reach = 3;   // in largest reaches
constexpr double most_chips = 32768;
constexpr double most_stretches = 16;  // of one piece of crack

/// A part of a piece of crack over which chips are as many.
struct Stretch {
  std::int32_t crack;
  double begin, end;   ///< from a, length
  double weight;       ///< chips per length
  double mean_length;  ///< of a chip
};

/// Expected reach of a chip where none is above `most`: reaches are even in their logarithm.
double mean_reach(double size, double most) {
  if (most >= size) return 0.75 / ln4 * size;
  if (most <= size / 4) return most;
  return (most - size / 4) / ln4 + most * elementary::log(size / most) / ln4;
}

double half_at(const std::array<double, 2>& half, double share) {
  return half[0] + share * (half[1] - half[0]);
}

class Placer {
 public:
  Placer(const std::vector<MapCrack>& cracks, const std::vector<std::array<double, 2>>& half_width,
         const ChipOptions& options)
      : cracks_(cracks), half_width_(half_width), options_(options) {
    size_ = options.size > 0 ? options.size : usual_size * options.spacing;
    size_ = std::min(size_, most_size * options.spacing);
  }

  Chips run() {
    Chips made;
    if (!(options_.share > 0 && size_ > 0)) return made;
    const double asked = size_;
    find_rate();
    for (double over; (over = expected() / most_chips) > 1 && size_ < most_size * options_.spacing;
         find_rate()) {
      size_ = std::min(std::max(over, 1.1) * size_, most_size * options_.spacing);
    }
    if (size_ > asked) {
      made.warnings.push_back(fmt::format(
          "post.chip_size is {:.3g}, not {:.3g}: smaller chips would be more than {:.0f}", size_,
          asked, most_chips));
    }
    draw(made);
    return made;
  }

 private:
  double length(std::int32_t crack) const { return (cracks_[crack].b - cracks_[crack].a).norm(); }

  /// By root: how far along the cracks the next junction is; none within reach: infinite.
  std::unordered_map<std::int32_t, double> junction_distances() const {
    std::unordered_map<std::int32_t, std::vector<std::int32_t>> at;
    for (std::size_t i = 0; i < cracks_.size(); ++i) {
      for (const std::int32_t root : cracks_[i].roots) {
        at[root].push_back(static_cast<std::int32_t>(i));
      }
    }
    using Entry = std::pair<double, std::int32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::unordered_map<std::int32_t, double> distance;
    for (const auto& [root, meeting] : at) {
      if (root >= 0 && meeting.size() > 2) queue.emplace(0, root);
    }
    while (!queue.empty()) {
      const double far = queue.top().first;
      const std::int32_t root = queue.top().second;
      queue.pop();
      const auto known = distance.find(root);
      if (known != distance.end() && known->second <= far) continue;
      distance[root] = far;
      for (const std::int32_t i : at.at(root)) {
        const double next = far + length(i);
        const auto& roots = cracks_[i].roots;
        const std::int32_t other = roots[0] == root ? roots[1] : roots[0];
        if (next < junction_reach * size_ && other >= 0) queue.emplace(next, other);
      }
    }
    return distance;
  }

  void find_stretches() {
    stretches_.clear();
    const auto junctions = junction_distances();
    const auto from_junction = [&](std::int32_t root) {
      const auto found = junctions.find(root);
      return found == junctions.end() ? std::numeric_limits<double>::infinity() : found->second;
    };
    const WidthByAge by_age = width_by_age(last_to_open, cracks_);
    for (std::size_t i = 0; i < cracks_.size(); ++i) {
      const auto crack = static_cast<std::int32_t>(i);
      const double all = length(crack);
      if (!(all > 0)) continue;
      const double a = from_junction(cracks_[i].roots[0]), b = from_junction(cracks_[i].roots[1]);
      const double parts = std::ceil(std::min(all / size_, most_stretches));
      for (double k = 0; k < parts; ++k) {
        const double middle = (k + 0.5) / parts;
        const double near = std::min(a + middle * all, b + (1 - middle) * all);
        const double crumbled = std::max(0.0, 1 - near / (junction_reach * size_));
        const double weight = by_age.factor(cracks_[i].time) * (1 + (at_junction - 1) * crumbled);
        const double half = half_at(half_width_[i], middle);
        const double mean = 2 * mean_reach(size_, most_per_half_width * half);
        if (!(mean > 0)) continue;
        stretches_.push_back({crack, k / parts * all, (k + 1) / parts * all, weight, mean});
      }
    }
  }

  /// Chips per length and weight: chips that lie at random leave exp(−their length per length) of a
  /// rim whole.
  void find_rate() {
    find_stretches();
    double all = 0;
    for (const Stretch& s : stretches_) all += s.end - s.begin;
    const double wanted = std::min(options_.share, most_share) * all;
    double low = 0, high = 8 / (last_to_open * size_);
    for (const Stretch& s : stretches_) {
      high = std::max(high, 8 / (s.weight * s.mean_length));
    }
    for (int step = 0; step < 40; ++step) {
      const double rate = (low + high) / 2;
      double covered = 0;
      for (const Stretch& s : stretches_) {
        covered += (s.end - s.begin) * (1 - elementary::exp(-rate * s.weight * s.mean_length));
      }
      (covered < wanted ? low : high) = rate;
    }
    rate_ = (low + high) / 2;
  }

  double expected() const {
    double count = 0;
    for (const Stretch& s : stretches_) count += 2 * rate_ * s.weight * (s.end - s.begin);
    return count;
  }

  void draw(Chips& made) const {
    made.first.assign(1, 0);
    made.extent.assign(cracks_.size(), 0);
    std::map<std::int32_t, std::uint64_t> pieces;  // of a crack, so far
    std::size_t next = 0;
    for (std::size_t i = 0; i < cracks_.size(); ++i) {
      const auto crack = static_cast<std::int32_t>(i);
      const std::uint64_t piece = pieces[cracks_[i].number]++;
      const std::size_t begin = next;
      while (next < stretches_.size() && stretches_[next].crack == crack) ++next;
      for (const bool left : {true, false}) {
        Random random(options_.seed,
                      hash_bits(hash_bits(static_cast<std::uint64_t>(cracks_[i].number)) ^ piece) ^
                          (left ? 1U : 0U));
        for (std::size_t k = begin; k < next; ++k) draw(stretches_[k], left, random, made);
      }
      made.first.push_back(static_cast<std::int32_t>(made.chips.size()));
    }
  }

  void draw(const Stretch& s, bool left, Random& random, Chips& made) const {
    const double all = length(s.crack), rate = rate_ * s.weight;
    for (double at = s.begin;;) {
      at -= elementary::log(1 - random.uniform()) / rate;
      if (!(at < s.end)) return;
      const double half = half_at(half_width_[s.crack], at / all);
      Chip chip{s.crack, left, at, 0, 0, 0, {}};
      chip.reach =
          std::min(size_ * elementary::exp(-ln4 * random.uniform()), most_per_half_width * half);
      chip.inwards = chip.reach * random.uniform(0.4, 0.9);
      chip.depth = std::min(chip.reach * random.uniform(0.25, 0.5), options_.deepest);
      for (double& wave : chip.ragged) wave = random.uniform(-0.2, 0.2);
      if (!(chip.reach > 0)) continue;
      made.chips.push_back(chip);
      made.extent[s.crack] =
          std::max(made.extent[s.crack], half + std::max(chip.reach, chip.inwards));
    }
  }

  const std::vector<MapCrack>& cracks_;
  const std::vector<std::array<double, 2>>& half_width_;
  const ChipOptions& options_;
  double size_ = 0, rate_ = 0;
  std::vector<Stretch> stretches_;
};

}  // namespace

double Chip::outline(const Vec2& p) const {
  const double x = p.x() / reach, y = std::max(p.y(), 0.0) / inwards;
  const double rho = std::sqrt(x * x + y * y);
  if (rho <= 0) return 0;
  const double c = x / rho, s = y / rho, cc = c * c;
  const std::array<double, 3> waves{2 * cc - 1, (4 * cc - 3) * c,
                                    ((16 * cc - 20) * cc + 5) * c};  // cos 2θ, 3θ, 5θ
  double narrower = 0;
  for (std::size_t i = 0; i < 3; ++i) narrower += std::abs(ragged[i]) + ragged[i] * waves[i];
  return rho * (1 + s * narrower);
}

double Chip::depth_at(const Vec2& p) const {
  const double rho = outline(p);
  return rho < 1 ? depth * (1 - rho * rho) : 0;
}

double Chip::inwards_at(double x) const {
  if (!(std::abs(x) < reach)) return 0;
  double low = 0, high = inwards;
  for (int step = 0; step < 20; ++step) {
    const double y = (low + high) / 2;
    (outline({x, y}) < 1 ? low : high) = y;
  }
  return (low + high) / 2;
}

ChipOptions chip_options(const PostParameters& post, double spacing, std::uint64_t seed) {
  constexpr double of_thickness = 0.5;
  ChipOptions options{post.chipping, post.chip_size, spacing};
  options.seed = seed;
  if (post.thickness > 0) {
    options.deepest = of_thickness * post.thickness;
  } else if (post.wall > 0) {
    options.deepest = chips_of_wall * post.wall;
  }
  return options;
}

Chips place_chips(const std::vector<MapCrack>& cracks,
                  const std::vector<std::array<double, 2>>& half_width,
                  const ChipOptions& options) {
  return Placer(cracks, half_width, options).run();
}

std::vector<std::array<CrackSide, 2>> sides_of_cracks(const std::vector<MapCrack>& cracks,
                                                      const TriangleMesh& cut) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> side;  // by the roots of its ends
  for (std::int32_t h = 0; h < 3 * cut.face_count(); ++h) {
    if (cut.crack_of(h) >= 0)
      side.emplace(std::pair{cut.root(cut.from(h)), cut.root(cut.to(h))}, h);
  }
  std::vector<std::array<CrackSide, 2>> sides(cracks.size());
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    const auto& [a, b] = cracks[i].roots;
    const auto left = side.find({a, b}), right = side.find({b, a});
    if (left != side.end()) sides[i][0].halfedge = left->second;
    if (right != side.end()) sides[i][1].halfedge = right->second;
  }
  return sides;
}

}  // namespace craze
