#include "callback_context.h"

namespace craze::c {

namespace {

constexpr auto interval = std::chrono::milliseconds(50);

}  // namespace

CallbackContext::CallbackContext(craze_progress progress, void* user, int threads)
    : progress_(progress), user_(user) {
  context_.threads = Threads(threads);
  if (!progress_) return;
  context_.progress = [this](const Progress& reached) {
    const bool new_phase = reached.phase != phase_;
    if (new_phase) phase_ = reached.phase;
    last_ = reached;
    if (new_phase || std::chrono::steady_clock::now() - asked_ >= interval) ask();
  };
  context_.cancelled = [this] {
    if (stopped_ || std::chrono::steady_clock::now() - asked_ < interval) return stopped_;
    return ask();
  };
}

bool CallbackContext::ask() {
  stopped_ =
      stopped_ || progress_(user_, phase_.c_str(), last_.fraction, last_.cracks, last_.load) != 0;
  asked_ = std::chrono::steady_clock::now();
  return stopped_;
}

}  // namespace craze::c
