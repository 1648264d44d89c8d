#include "opened_pieces.h"

#include "callback_context.h"

namespace craze::c {

void OpenedPieces::add(const OpenedPiece& piece) {
  if (piece.number == 0) {
    tell();
    told_ = 0;
  }
  waiting_.insert(waiting_.end(), piece.from.data(), piece.from.data() + 3);
  waiting_.insert(waiting_.end(), piece.to.data(), piece.to.data() + 3);
  if (std::chrono::steady_clock::now() - last_ >= callback_interval) tell();
}

void OpenedPieces::tell() {
  if (waiting_.empty()) return;
  const auto count = static_cast<std::int64_t>(waiting_.size() / 6);
  opened_(user_, told_, waiting_.data(), count);
  told_ += count;
  waiting_.clear();
  last_ = std::chrono::steady_clock::now();
}

}  // namespace craze::c
