// One updating line on the terminal.
#pragma once

#include <chrono>
#include <string>

#include "terminal/progress_view.h"

namespace craze::app {

/// Draws at most ten times a second; clears its line when destroyed. Draws nothing unless standard
/// error is a terminal.
class ProgressLine : public ProgressView {
 public:
  ProgressLine();
  ~ProgressLine() override;

  void update(const Progress& progress) override;

 private:
  using Clock = std::chrono::steady_clock;

  bool shown_;
  std::string phase_;
  Clock::time_point phase_start_;
  Clock::time_point last_draw_;
  std::int64_t cracks_at_start_ = 0;
};

/// "crack  1200 cracks, 400/s, load 1.53, 20480 triangles, 37 %, 12 s left": what is known of it,
/// `seconds` into the phase that began with `cracks_before`.
std::string progress_text(const Progress& progress, double seconds, std::int64_t cracks_before);

}  // namespace craze::app
