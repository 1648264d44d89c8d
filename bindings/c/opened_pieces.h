// Pieces of crack as they open, told in lots.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "craze/craze.h"
#include "craze/opened_piece.h"

namespace craze::c {

/// Tells the callback at most about twenty times a second, and of one pattern at a time.
class OpenedPieces {
 public:
  OpenedPieces(craze_opened opened, void* user) : opened_(opened), user_(user) {}

  void add(const OpenedPiece& piece);
  /// What has not been told yet.
  void tell();

 private:
  craze_opened opened_;
  void* user_;
  std::vector<double> waiting_;  // six each
  std::int64_t told_ = 0;        // of this pattern
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace craze::c
