#include "terminal/progress_json.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace craze::app {

namespace {

constexpr auto write_interval = std::chrono::milliseconds(100);

}  // namespace

std::string progress_object(const std::string& phase, const Progress& progress) {
  nlohmann::ordered_json line{{"phase", phase},
                              {"fraction", nullptr},
                              {"cracks", progress.cracks},
                              {"load", progress.load}};
  if (progress.fraction >= 0) line["fraction"] = std::min(progress.fraction, 1.0);
  return line.dump();
}

ProgressJson::~ProgressJson() {
  write_pending();
}

void ProgressJson::update(const Progress& progress) {
  const bool new_phase = progress.phase != phase_;
  if (new_phase) {
    write_pending();
    phase_ = progress.phase;
  }
  pending_ = progress;
  pending_->phase = {};
  if (new_phase || Clock::now() - last_write_ >= write_interval) write_pending();
}

void ProgressJson::write_pending() {
  if (!pending_) return;
  std::fprintf(stderr, "%s\n", progress_object(phase_, *pending_).c_str());
  std::fflush(stderr);
  pending_.reset();
  last_write_ = Clock::now();
}

}  // namespace craze::app
