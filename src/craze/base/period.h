// The period of a surface that repeats along x and y: a flat torus.
#pragma once

#include <cmath>

#include "craze/tensor.h"

namespace craze {

/// Places that differ by whole periods along x and y are one place. Of its images a vertex names
/// any; what is measured between two places is measured between the nearest images of them, so
/// all that is looked at together must be nearer than half a period.
struct Period {
  double length = 0;  ///< along x and along y, model units; 0: nothing repeats

  bool is_given() const { return length > 0; }
  /// The image of `v`, the way from one place to another, that is the shortest.
  Vec3 shortest(const Vec3& v) const { return is_given() ? image(v, Vec3::Zero()) : v; }
  /// The image of p that is nearest to `to`; p itself where nothing repeats.
  Vec3 nearest(const Vec3& p, const Vec3& to) const { return is_given() ? image(p, to) : p; }
  /// The image of p in [0, length)² but for rounding; p itself where nothing repeats.
  Vec3 wrapped(const Vec3& p) const {
    if (!is_given()) return p;
    return {p.x() - length * std::floor(p.x() / length),
            p.y() - length * std::floor(p.y() / length), p.z()};
  }
  /// Calls visit(q) for every image q of p that is within `reach` of [0, length]² along both axes;
  /// for p itself alone where nothing repeats. A search among wrapped() places looks from all.
  template <class Visit>
  void for_each_image(const Vec3& p, double reach, Visit&& visit) const {
    if (!is_given()) {
      visit(p);
      return;
    }
    const Vec3 home = wrapped(p);
    const auto first = [&](double x) { return std::ceil((-reach - x) / length); };
    const auto last = [&](double x) { return std::floor((length + reach - x) / length); };
    for (double i = first(home.x()); i <= last(home.x()); ++i) {
      for (double j = first(home.y()); j <= last(home.y()); ++j) {
        visit(Vec3(home.x() + i * length, home.y() + j * length, home.z()));
      }
    }
  }

 private:
  Vec3 image(const Vec3& p, const Vec3& to) const {
    return {p.x() - length * std::round((p.x() - to.x()) / length),
            p.y() - length * std::round((p.y() - to.y()) / length), p.z()};
  }
};

}  // namespace craze
