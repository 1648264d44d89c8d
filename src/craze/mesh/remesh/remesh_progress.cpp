#include "craze/mesh/remesh/remesh_progress.h"

#include <algorithm>

namespace craze {

namespace {

constexpr const char* phase = "remesh";

}  // namespace

RemeshProgress::RemeshProgress(const Context& context, int stages)
    : context_(context), stage_context_(context), stages_(stages) {
  stage_context_.progress = [this](const Progress& p) {
    part_ = std::max(part_, p.fraction);
    context_.report({phase, (done_ + part_) / stages_, 0, p.triangles});
  };
}

void RemeshProgress::finish(std::int64_t triangles) {
  part_ = 0;
  done_ = stages_;
  look(triangles);
}

void RemeshProgress::next_stage(std::int64_t triangles) {
  ++done_;
  part_ = 0;
  look(triangles);
}

void RemeshProgress::look(std::int64_t triangles) {
  context_.check();
  context_.report({phase, (done_ + part_) / stages_, 0, triangles});
}

}  // namespace craze
