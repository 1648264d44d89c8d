// Encodings: The Unicode Standard, chapter 3.10 and section 23.8.
#include "craze/io/bytes/text_encoding.h"

#include <cstdint>

#include "craze/io/bytes/input_error.h"

namespace craze {

namespace {

enum class Encoding { none, utf8, utf16_little, utf16_big, utf32 };

Encoding encoding_of(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xef\xbb\xbf")) return Encoding::utf8;
  if (bytes.starts_with("\xff\xfe\0\0"sv) || bytes.starts_with("\0\0\xfe\xff"sv)) {
    return Encoding::utf32;
  }
  if (bytes.starts_with("\xff\xfe")) return Encoding::utf16_little;
  if (bytes.starts_with("\xfe\xff")) return Encoding::utf16_big;
  return Encoding::none;
}

void append_utf8(std::string& text, std::uint32_t code) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((code >> shift) & 0x3f)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xc0 | (code >> 6));
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xe0 | (code >> 12));
    tail(6);
    tail(0);
  } else {
    text += static_cast<char>(0xf0 | (code >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

std::string utf16_to_utf8(std::string_view bytes, bool big) {
  constexpr std::uint32_t replacement = 0xfffd;
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto a = static_cast<unsigned char>(bytes[2 * i]);
    const auto b = static_cast<unsigned char>(bytes[2 * i + 1]);
    return big ? 256u * a + b : 256u * b + a;
  };
  const std::size_t units = bytes.size() / 2;
  std::string text;
  text.reserve(units);
  for (std::size_t i = 0; i < units; ++i) {
    const std::uint32_t high = unit(i);
    if (high < 0xd800 || high > 0xdfff) {
      append_utf8(text, high);
      continue;
    }
    const std::uint32_t low = high < 0xdc00 && i + 1 < units ? unit(i + 1) : 0;
    const bool is_pair = low >= 0xdc00 && low <= 0xdfff;
    append_utf8(text, is_pair ? 0x10000 + ((high - 0xd800) << 10) + (low - 0xdc00) : replacement);
    if (is_pair) ++i;
  }
  return text;
}

}  // namespace

bool has_byte_order_mark(std::string_view bytes) {
  return encoding_of(bytes) != Encoding::none;
}

std::string decode_text(std::string_view bytes, const std::string& name) {
  switch (encoding_of(bytes)) {
    case Encoding::utf8:
      return std::string(bytes.substr(3));
    case Encoding::utf16_little:
      return utf16_to_utf8(bytes.substr(2), false);
    case Encoding::utf16_big:
      return utf16_to_utf8(bytes.substr(2), true);
    case Encoding::utf32:
      fail_input(name, "it is text in UTF-32; save it as UTF-8");
    case Encoding::none:
      break;
  }
  return std::string(bytes);
}

}  // namespace craze
