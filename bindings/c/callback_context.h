// A callback of the interface as a Context.
#pragma once

#include <chrono>
#include <string>

#include "craze/context.h"
#include "craze/craze.h"
#include "handles.h"

namespace craze::c {

/// Asks the callback at most about twenty times a second, and at each new phase; once it has asked
/// to stop, everything stops. Must outlive the call that its context is handed to.
class CallbackContext {
 public:
  CallbackContext(craze_progress progress, void* user, int threads = 0);
  explicit CallbackContext(const craze_job& job)
      : CallbackContext(job.progress, job.user, job.threads) {}
  CallbackContext(const CallbackContext&) = delete;
  CallbackContext& operator=(const CallbackContext&) = delete;

  const Context& get() const { return context_; }

 private:
  bool ask();

  craze_progress progress_;
  void* user_;
  Context context_;
  Progress last_;
  std::string phase_ = "start";
  std::chrono::steady_clock::time_point asked_{};
  bool stopped_ = false;
};

}  // namespace craze::c
