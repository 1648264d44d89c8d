// Somewhere that shows how far a run is.
#pragma once

#include "craze/context.h"

namespace craze::app {

class ProgressView {
 public:
  ProgressView() = default;
  ProgressView(const ProgressView&) = delete;
  ProgressView& operator=(const ProgressView&) = delete;
  virtual ~ProgressView() = default;

  virtual void update(const Progress& progress) = 0;
};

}  // namespace craze::app
