// How large a picture may be, and how its reading fails.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace craze {

inline constexpr std::uint32_t largest_side = 16384;

/// Throws Error(input) "cannot read picture (NAME): WHY".
[[noreturn]] void fail_image(const std::string& name, const std::string& why);

/// Refuses sizes beyond the limit, and files of `bytes` that cannot hold so many pixels where no
/// more than `pixels_per_byte` fit into one: no memory is reserved for a lie.
void check_image_size(std::uint32_t width, std::uint32_t height, std::size_t bytes,
                      std::uint64_t pixels_per_byte, const std::string& name);

}  // namespace craze
