// [IO06] §3.1 and §4.2: the priority queue of the nodes that can fail.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace craze {

/// Nodes by failure measure, greatest first; ties go to the lower index, so that the order is the
/// same on every run. Those far from the top wait without order until it has come down to them, so
/// that the heap stays small and most changes are one write: O(1) below the heap, O(log #heap) in
/// it, O(#V) each time that it has run empty, by when the top is lower by a tenth at least.
class FailureQueue {
 public:
  /// Puts v in, moves it, or takes it out where measure ≤ 0.
  void set(std::int32_t v, double measure);
  void remove(std::int32_t v) { set(v, 0); }

  bool empty() const { return heap_.empty() && waiting_ == 0; }
  /// Must not be empty.
  std::int32_t top();
  /// The first nodes of at least that measure > 0 in their order, as far as they are in the heap,
  /// and no more than `most`. O(#them log #them).
  std::vector<std::int32_t> first(double measure, std::size_t most) const;
  /// The measure of v; 0 where it is not queued.
  double measure(std::int32_t v) const {
    return v < static_cast<std::int32_t>(measures_.size()) ? measures_[v] : 0;
  }

  void shrink_to_fit() {
    heap_.shrink_to_fit();
    slot_.shrink_to_fit();
    measures_.shrink_to_fit();
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
  // Four children to a place: half the levels of two, and they lie side by side.
  static constexpr std::size_t children = 4;

  void sift(std::size_t i);
  void push(std::int32_t v, double measure);
  void take_out(std::int32_t v);

  std::vector<Entry> heap_;         // of measures from least_ on
  std::vector<std::int32_t> slot_;  // #V, position in the heap, −1: not there
  std::vector<double> measures_;    // #V, 0: not queued
  double least_ = std::numeric_limits<double>::infinity();
  std::int64_t waiting_ = 0;  // nodes that are queued but not in the heap
};

}  // namespace craze
