#include "job_context.h"

namespace craze::c {

namespace {

constexpr auto interval = std::chrono::milliseconds(50);

}  // namespace

JobContext::JobContext(const craze_job& job) : job_(job) {
  context_.threads = Threads(job.threads);
  if (!job.progress) return;
  context_.progress = [this](const Progress& progress) {
    const bool new_phase = progress.phase != phase_;
    if (new_phase) phase_ = progress.phase;
    last_ = progress;
    if (new_phase || std::chrono::steady_clock::now() - asked_ >= interval) ask();
  };
  context_.cancelled = [this] {
    if (stopped_ || std::chrono::steady_clock::now() - asked_ < interval) return stopped_;
    return ask();
  };
}

bool JobContext::ask() {
  stopped_ = stopped_ || job_.progress(job_.user, phase_.c_str(), last_.fraction, last_.cracks,
                                       last_.load) != 0;
  asked_ = std::chrono::steady_clock::now();
  return stopped_;
}

}  // namespace craze::c
