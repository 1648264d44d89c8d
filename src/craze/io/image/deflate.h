// Packing bytes by zlib, where the build has it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace craze {

bool has_deflate();

/// A whole zlib stream.
std::string zlib_pack(std::string_view bytes);

/// A part of a raw deflate stream that depends on nothing before it; parts one after the other are
/// a stream, which the last one ends.
std::string deflate_part(std::string_view bytes, bool last);

std::uint32_t adler(std::string_view bytes);
/// Of two texts one after the other, from those of each; `length`: of the second.
std::uint32_t adler_of_both(std::uint32_t first, std::uint32_t second, std::size_t length);

}  // namespace craze
