#include "craze/model/failure/failure_queue.h"

#include <algorithm>
#include <cassert>

namespace craze {

namespace {

// The heap begins with the nodes from this part of the greatest measure on.
constexpr double heaped_part = 0.9;

}  // namespace

void FailureQueue::set(std::int32_t v, double measure) {
  measure = measure > 0 ? measure : 0;
  if (v >= static_cast<std::int32_t>(slot_.size())) {
    if (measure == 0) return;
    slot_.resize(v + 1, -1);
    measures_.resize(v + 1, 0);
  }
  const bool was_heaped = slot_[v] >= 0;
  if (!was_heaped && measures_[v] > 0) --waiting_;
  measures_[v] = measure;
  if (measure > 0 && measure >= least_) {
    push(v, measure);
    return;
  }
  if (was_heaped) take_out(v);
  if (measure > 0) ++waiting_;
}

std::int32_t FailureQueue::top() {
  assert(!empty());
  if (heap_.empty()) {
    least_ = heaped_part * *std::max_element(measures_.begin(), measures_.end());
    for (std::size_t v = 0; v < measures_.size(); ++v) {
      if (measures_[v] > 0 && measures_[v] >= least_) {
        push(static_cast<std::int32_t>(v), measures_[v]);
        --waiting_;
      }
    }
  }
  return heap_.front().node;
}

std::vector<std::int32_t> FailureQueue::first(double measure, std::size_t most) const {
  // Places of the heap whose parent has been taken, the first of them in front.
  std::vector<std::size_t> reached;
  const auto after = [&](std::size_t a, std::size_t b) { return heap_[b].before(heap_[a]); };
  const auto reach = [&](std::size_t i) {
    if (!(heap_[i].measure >= measure)) return;
    reached.push_back(i);
    std::push_heap(reached.begin(), reached.end(), after);
  };
  if (!heap_.empty()) reach(0);
  std::vector<std::int32_t> nodes;
  while (!reached.empty() && nodes.size() < most) {
    std::pop_heap(reached.begin(), reached.end(), after);
    const std::size_t i = reached.back();
    reached.pop_back();
    nodes.push_back(heap_[i].node);
    const std::size_t child = children * i + 1;
    for (std::size_t c = child; c < std::min(child + children, heap_.size()); ++c) reach(c);
  }
  return nodes;
}

void FailureQueue::push(std::int32_t v, double measure) {
  if (slot_[v] < 0) {
    slot_[v] = static_cast<std::int32_t>(heap_.size());
    heap_.push_back({measure, v});
  }
  heap_[slot_[v]].measure = measure;
  sift(slot_[v]);
}

void FailureQueue::take_out(std::int32_t v) {
  const std::int32_t slot = slot_[v];
  const Entry last = heap_.back();
  heap_.pop_back();
  slot_[v] = -1;
  if (last.node != v) {
    place(slot, last);
    sift(slot);
  }
}

void FailureQueue::sift(std::size_t i) {
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
