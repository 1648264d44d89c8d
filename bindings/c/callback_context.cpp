#include "callback_context.h"

namespace craze::c {

CallbackContext::CallbackContext(craze_progress progress, void* user, int threads)
    : progress_(progress), user_(user) {
  context_.threads = Threads(threads);
  if (!progress_) return;
  context_.progress = [this](const Progress& reached) {
    const bool new_phase = reached.phase != phase_;
    if (new_phase && untold_) ask();
    if (new_phase) phase_ = reached.phase;
    last_ = reached;
    untold_ = true;
    if (new_phase || reached.fraction >= 1 || Clock::now() - asked_ >= callback_interval) ask();
  };
  context_.cancelled = [this] {
    if (stopped_ || Clock::now() - asked_ < callback_interval) return stopped_;
    return ask();
  };
}

bool CallbackContext::ask() {
  stopped_ =
      stopped_ || progress_(user_, phase_.c_str(), last_.fraction, last_.cracks, last_.load) != 0;
  asked_ = Clock::now();
  untold_ = false;
  return stopped_;
}

}  // namespace craze::c
