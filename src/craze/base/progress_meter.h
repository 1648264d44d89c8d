// Progress and cancellation of a loop that cannot stop halfway, and progress of parts of a phase.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string_view>

#include "craze/context.h"

namespace craze {

/// Reports how far a loop has come and hears that it is cancelled, once every `step` units of work,
/// so that the loop itself pays a comparison. An empty phase reports nothing.
class ProgressMeter {
 public:
  /// `context` must outlive this. `total`: where the units end; 0: not known.
  ProgressMeter(const Context& context, std::string_view phase, std::size_t total,
                std::size_t step = std::size_t{1} << 14)
      : context_(context), phase_(phase), total_(total), step_(step) {}

  /// `done` units are done; it never falls. Throws Cancelled.
  void at(std::size_t done) {
    if (done >= next_) look(done);
  }
  /// All are done. Throws Cancelled.
  void finish() { look(total_); }

 private:
  void look(std::size_t done) {
    next_ = done + step_;
    if (context_.is_cancelled()) throw Cancelled();
    if (phase_.empty()) return;
    Progress progress;
    progress.phase = phase_;
    if (total_ > 0) progress.fraction = static_cast<double>(done) / static_cast<double>(total_);
    context_.report(progress);
  }

  const Context& context_;
  std::string_view phase_;
  std::size_t total_, step_, next_ = 0;
};

/// Whatever is reported through it is told to `context` as `phase`, between the fractions `from`
/// and `to`, and never less than before. `context` and the text of `phase` must outlive it.
inline Context phase_part(const Context& context, std::string_view phase, double from, double to) {
  Context part = context;
  const auto reached = std::make_shared<double>(0);
  part.progress = [&context, phase, from, to, reached](const Progress& p) {
    *reached = std::max(*reached, std::min(p.fraction, 1.0));
    const double fraction = *reached < 1 ? from + (to - from) * *reached : to;
    context.report({phase, fraction, p.cracks, p.triangles, p.load});
  };
  return part;
}

}  // namespace craze
