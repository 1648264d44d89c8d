// [IO06] §3.1 and §4.2: the priority queue of the nodes that can fail.
#pragma once

#include <cstdint>
#include <vector>

namespace craze {

/// Nodes by failure measure, greatest first; ties go to the lower index, so that the order is the
/// same on every run. Every operation costs at most O(log #queued).
class FailureQueue {
 public:
  /// Puts v in, moves it, or takes it out where measure ≤ 0.
  void set(std::int32_t v, double measure);
  void remove(std::int32_t v) { set(v, 0); }

  bool empty() const { return heap_.empty(); }
  std::int32_t top() const { return heap_.front(); }
  /// The measure of v; 0 where it is not queued.
  double measure(std::int32_t v) const {
    return v < static_cast<std::int32_t>(measure_.size()) ? measure_[v] : 0;
  }

 private:
  bool before(std::int32_t a, std::int32_t b) const {
    return measure_[a] != measure_[b] ? measure_[a] > measure_[b] : a < b;
  }
  void place(std::size_t i, std::int32_t v) {
    heap_[i] = v;
    slot_[v] = static_cast<std::int32_t>(i);
  }
  void sift(std::size_t i);

  std::vector<std::int32_t> heap_;
  std::vector<std::int32_t> slot_;  // #V, position in the heap, −1: not queued
  std::vector<double> measure_;     // #V
};

}  // namespace craze
