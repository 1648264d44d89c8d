// Base64 (RFC 4648).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace craze {

/// The bytes; empty optional where a character is not of the alphabet or the length is impossible.
/// Padding may be missing.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace craze
