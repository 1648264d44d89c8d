// Progress for other programs: one JSON object a line on standard error.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "terminal/progress_view.h"

namespace craze::app {

/// {"phase": "crack", "fraction": 0.37, "cracks": 1200, "load": 1.53}, the fraction null where no
/// end is known. Every phase's first and last state, and between them at most ten a second.
class ProgressJson : public ProgressView {
 public:
  ~ProgressJson() override;

  void update(const Progress& progress) override;

 private:
  using Clock = std::chrono::steady_clock;

  void write_pending();

  std::string phase_;
  std::optional<Progress> pending_;  ///< the last state, where it is not written yet; no phase
  Clock::time_point last_write_;
};

/// The line, without its end.
std::string progress_object(const std::string& phase, const Progress& progress);

}  // namespace craze::app
