// How far remeshing is, and whether it goes on.
#pragma once

#include <cstdint>

#include "craze/context.h"

namespace craze {

/// Remeshing as a sequence of stages of about equal length, reported as the phase "remesh".
class RemeshProgress {
 public:
  RemeshProgress(const Context& context, int stages);
  RemeshProgress(const RemeshProgress&) = delete;
  RemeshProgress& operator=(const RemeshProgress&) = delete;

  /// Each stage begins with this. Throws Cancelled.
  void next_stage(std::int64_t triangles);

  /// After the last. Throws Cancelled.
  void finish(std::int64_t triangles);

  /// For every edge, face or vertex looked at: costs next to nothing, and once in a few thousand
  /// calls reports and throws Cancelled where the context says so.
  void step(std::int64_t triangles) {
    if (++steps_ % steps_between_looks == 0) look(triangles);
  }

  /// The context of the present stage: its fractions are parts of the stage.
  const Context& stage() const { return stage_context_; }

 private:
  static constexpr std::int64_t steps_between_looks = 4096;  // about ten milliseconds

  void look(std::int64_t triangles);

  const Context& context_;
  Context stage_context_;
  double stages_;
  double done_ = -1;  // stages; none has begun
  double part_ = 0;   // of the present one; never less than before
  std::int64_t steps_ = 0;
};

}  // namespace craze
