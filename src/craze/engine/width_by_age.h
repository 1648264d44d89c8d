// post.late_width: cracks that have been open for longer are wider.
#pragma once

#include <algorithm>

namespace craze {

/// What the width of a crack is multiplied by: 1 for the first that opened, `late` for the last,
/// the others in between in proportion to their times.
class WidthByAge {
 public:
  explicit WidthByAge(double late) : late_(late) {}
  /// Of cracks whose first and last time are known.
  WidthByAge(double late, double first, double last) : late_(late) {
    add(first);
    add(last);
  }

  /// Every crack's time comes here first.
  void add(double time) {
    first_ = any_ ? std::min(first_, time) : time;
    last_ = any_ ? std::max(last_, time) : time;
    any_ = true;
  }

  bool all_alike() const { return late_ == 1; }
  double factor(double time) const {
    if (all_alike() || !(last_ > first_)) return 1;
    return 1 + (late_ - 1) * (std::clamp(time, first_, last_) - first_) / (last_ - first_);
  }

 private:
  double late_, first_ = 0, last_ = 0;
  bool any_ = false;
};

/// Of all cracks of a list whose items have a `time`.
template <class Cracks>
WidthByAge width_by_age(double late, const Cracks& cracks) {
  WidthByAge width(late);
  for (const auto& crack : cracks) width.add(crack.time);
  return width;
}

}  // namespace craze
