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
  std::int32_t top() const { return heap_.front().node; }
  /// The measure of v; 0 where it is not queued.
  double measure(std::int32_t v) const {
    const std::int32_t slot = v < static_cast<std::int32_t>(slot_.size()) ? slot_[v] : -1;
    return slot < 0 ? 0 : heap_[slot].measure;
  }

  void shrink_to_fit() {
    heap_.shrink_to_fit();
    slot_.shrink_to_fit();
  }

 private:
  struct Entry {
    double measure;
    std::int32_t node;

    bool before(const Entry& other) const {
      return measure != other.measure ? measure > other.measure : node < other.node;
    }
  };

  void place(std::size_t i, const Entry& entry) {
    heap_[i] = entry;
    slot_[entry.node] = static_cast<std::int32_t>(i);
  }
  void sift(std::size_t i);

  std::vector<Entry> heap_;
  std::vector<std::int32_t> slot_;  // #V, position in the heap, −1: not queued
};

}  // namespace craze
