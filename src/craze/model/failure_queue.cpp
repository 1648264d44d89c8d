#include "craze/model/failure_queue.h"

namespace craze {

void FailureQueue::set(std::int32_t v, double measure) {
  if (v >= static_cast<std::int32_t>(slot_.size())) {
    if (!(measure > 0)) return;
    slot_.resize(v + 1, -1);
    measure_.resize(v + 1, 0);
  }
  std::int32_t slot = slot_[v];
  if (measure > 0) {
    measure_[v] = measure;
    if (slot < 0) {
      slot = static_cast<std::int32_t>(heap_.size());
      heap_.push_back(v);
      slot_[v] = slot;
    }
    sift(slot);
    return;
  }
  if (slot < 0) return;
  const std::int32_t last = heap_.back();
  heap_.pop_back();
  slot_[v] = -1;
  measure_[v] = 0;
  if (last != v) {
    place(slot, last);
    sift(slot);
  }
}

void FailureQueue::sift(std::size_t i) {
  const std::int32_t v = heap_[i];
  while (i > 0 && before(v, heap_[(i - 1) / 2])) {
    place(i, heap_[(i - 1) / 2]);
    i = (i - 1) / 2;
  }
  for (std::size_t child = 2 * i + 1; child < heap_.size(); child = 2 * i + 1) {
    if (child + 1 < heap_.size() && before(heap_[child + 1], heap_[child])) ++child;
    if (!before(heap_[child], v)) break;
    place(i, heap_[child]);
    i = child;
  }
  place(i, v);
}

}  // namespace craze
