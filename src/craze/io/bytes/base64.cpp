#include "craze/io/bytes/base64.h"

#include <algorithm>

#include <cstdint>

namespace craze {

namespace {

int digit_of(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  if (c == '/') return 63;
  return -1;
}

}  // namespace

std::optional<std::string> decode_base64(std::string_view text) {
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const int digit = digit_of(c);
    if (digit < 0) return std::nullopt;
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes += static_cast<char>((bits >> held) & 0xff);
    }
  }
  return bytes;
}

namespace {

constexpr std::string_view scheme = "data:", encoding = ";base64";

bool equal_ignoring_case(std::string_view text, std::string_view lower) {
  return std::equal(text.begin(), text.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

/// What stands before the comma.
std::string_view head_of(std::string_view uri) {
  return uri.substr(0, std::min(uri.find(','), uri.size()));
}

}  // namespace

bool is_data_uri(std::string_view uri) {
  return equal_ignoring_case(uri.substr(0, scheme.size()), scheme);
}

std::string_view data_uri_type(std::string_view uri) {
  const std::string_view head = head_of(uri).substr(scheme.size());
  return head.substr(0, std::min(head.find(';'), head.size()));
}

std::optional<std::string> decode_data_uri(std::string_view uri) {
  const std::string_view head = head_of(uri);
  if (head.size() == uri.size() || head.size() < encoding.size() ||
      !equal_ignoring_case(head.substr(head.size() - encoding.size()), encoding)) {
    return std::nullopt;
  }
  return decode_base64(uri.substr(head.size() + 1));
}

}  // namespace craze
