#include "craze/model/failure/failure_queue.h"

#include <algorithm>

namespace craze {

void FailureQueue::set(std::int32_t v, double measure) {
  if (v >= static_cast<std::int32_t>(slot_.size())) {
    if (!(measure > 0)) return;
    slot_.resize(v + 1, -1);
  }
  std::int32_t slot = slot_[v];
  if (measure > 0) {
    if (slot < 0) {
      slot = static_cast<std::int32_t>(heap_.size());
      heap_.push_back({measure, v});
      slot_[v] = slot;
    }
    heap_[slot].measure = measure;
    sift(slot);
    return;
  }
  if (slot < 0) return;
  const Entry last = heap_.back();
  heap_.pop_back();
  slot_[v] = -1;
  if (last.node != v) {
    place(slot, last);
    sift(slot);
  }
}

void FailureQueue::sift(std::size_t i) {
  // Four children to a place: half the levels of two, and they lie side by side.
  constexpr std::size_t children = 4;
  const Entry entry = heap_[i];
  while (i > 0 && entry.before(heap_[(i - 1) / children])) {
    place(i, heap_[(i - 1) / children]);
    i = (i - 1) / children;
  }
  for (std::size_t first = children * i + 1; first < heap_.size(); first = children * i + 1) {
    const std::size_t end = std::min(first + children, heap_.size());
    std::size_t best = first;
    for (std::size_t c = first + 1; c < end; ++c) {
      if (heap_[c].before(heap_[best])) best = c;
    }
    if (!heap_[best].before(entry)) break;
    place(i, heap_[best]);
    i = best;
  }
  place(i, entry);
}

}  // namespace craze
