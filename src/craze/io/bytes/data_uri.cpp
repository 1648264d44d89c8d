#include "craze/io/bytes/data_uri.h"

#include <algorithm>

#include "craze/io/bytes/base64.h"

namespace craze {

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
