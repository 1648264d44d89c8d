// What a thread takes of a picture.
#pragma once

#include <cstddef>

namespace craze {

/// Rows of texels: few, since they differ in what they cost.
inline constexpr std::size_t rows_at_once = 4;

}  // namespace craze
