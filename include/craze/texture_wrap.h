// How a picture goes on beyond its borders.
#pragma once

#include <array>

namespace craze {

enum class TextureWrap {
  repeat,
  clamp,   ///< its outermost pixels go on
  mirror,  ///< it repeats, every second time the other way round
};

using TextureWraps = std::array<TextureWrap, 2>;  ///< along u and v

}  // namespace craze
