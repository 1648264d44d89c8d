// A callback of the interface as a Context.
#pragma once

#include <chrono>
#include <string>

#include "craze/context.h"
#include "craze/craze.h"
#include "handles.h"

namespace craze::c {

/// Between two calls of a callback.
inline constexpr auto callback_interval = std::chrono::milliseconds(50);

/// Asks the callback about twenty times a second, and at the start and the end of each phase; once
/// it has asked to stop, everything stops. Must outlive the call that its context is handed to.
class CallbackContext {
 public:
  CallbackContext(craze_progress progress, void* user, int threads = 0);
  explicit CallbackContext(const craze_job& job)
      : CallbackContext(job.progress, job.user, job.threads) {}
  CallbackContext(const CallbackContext&) = delete;
  CallbackContext& operator=(const CallbackContext&) = delete;

  const Context& get() const { return context_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool ask();

  craze_progress progress_;
  void* user_;
  Context context_;
  Progress last_;
  std::string phase_ = "start";
  Clock::time_point asked_{};
  bool untold_ = false;  ///< last_ has not been handed on
  bool stopped_ = false;
};

}  // namespace craze::c
