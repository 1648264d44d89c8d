// The callback of a job as a Context.
#pragma once

#include "craze/context.h"
#include "handles.h"

namespace craze::c {

/// Asks the callback at most about twenty times a second, and at each new phase; once it has asked
/// to stop, everything stops. Must outlive the call that its context is handed to.
class JobContext {
 public:
  explicit JobContext(const craze_job& job);
  JobContext(const JobContext&) = delete;
  JobContext& operator=(const JobContext&) = delete;

  const Context& get() const { return context_; }

 private:
  bool ask();

  const craze_job& job_;
  Context context_;
  Progress last_;
  std::string phase_ = "start";
  std::chrono::steady_clock::time_point asked_{};
  bool stopped_ = false;
};

}  // namespace craze::c
