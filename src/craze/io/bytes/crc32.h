// The checksum of PNG and zip; ISO/IEC 15948:2004, annex D.
#pragma once

#include <cstdint>
#include <string_view>

namespace craze {

std::uint32_t crc32(std::string_view bytes);

}  // namespace craze
