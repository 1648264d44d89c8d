// Text files in encodings other than plain UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace craze {

/// Whether the bytes begin with the byte order mark of UTF-8, UTF-16 or UTF-32.
bool has_byte_order_mark(std::string_view bytes);

/// A text with a byte order mark as UTF-8 without one. What is broken in UTF-16 becomes U+FFFD.
/// Throws Error(input) for UTF-32, by name.
std::string decode_text(std::string_view bytes, const std::string& name);

}  // namespace craze
