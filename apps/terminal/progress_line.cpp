#include "terminal/progress_line.h"

#include <unistd.h>

#include <cstdio>

#include "craze/base/text/format.h"

namespace craze::app {

namespace {

constexpr auto draw_interval = std::chrono::milliseconds(100);
constexpr double shortest_estimate = 1;  // seconds after which rates mean something

}  // namespace

std::string progress_text(const Progress& p, double seconds, std::int64_t cracks_before) {
  std::string text = fmt::format("{:<10}", p.phase);
  if (p.cracks > 0) text += fmt::format(" {} cracks", p.cracks);
  if (p.cracks > cracks_before && seconds >= shortest_estimate) {
    text += fmt::format(", {:.0f}/s", static_cast<double>(p.cracks - cracks_before) / seconds);
  }
  if (p.load > 0) text += fmt::format("  load {:.4g}", p.load);
  if (p.triangles > 0) text += fmt::format("  {} triangles", p.triangles);
  if (p.fraction >= 0) text += fmt::format("  {:.0f} %", 100 * p.fraction);
  if (p.fraction > 0 && seconds >= shortest_estimate) {
    text += fmt::format("  {:.0f} s left", seconds * (1 - p.fraction) / p.fraction);
  }
  return text;
}

ProgressLine::ProgressLine() : shown_(isatty(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
}

void ProgressLine::update(const Progress& progress) {
  if (!shown_) return;
  const auto now = Clock::now();
  const bool new_phase = progress.phase != phase_;
  if (new_phase) {
    phase_ = progress.phase;
    phase_start_ = now;
    cracks_at_start_ = progress.cracks;
  } else if (now - last_draw_ < draw_interval) {
    return;
  }
  last_draw_ = now;
  const double seconds = std::chrono::duration<double>(now - phase_start_).count();
  std::fprintf(stderr, "\r%s\x1b[K", progress_text(progress, seconds, cracks_at_start_).c_str());
  std::fflush(stderr);
}

}  // namespace craze::app
