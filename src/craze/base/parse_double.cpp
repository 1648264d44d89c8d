#include "craze/base/parse_double.h"

#ifndef __cpp_lib_to_chars
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#endif

namespace craze {

std::from_chars_result parse_double(const char* first, const char* last, double& value) {
#ifdef __cpp_lib_to_chars
  return std::from_chars(first, last, value);
#else
  const auto ends = [](char c) {
    return std::strchr("0123456789+-.eE", c) == nullptr || c == '\0';
  };
  const std::string text(first, std::find_if(first, last, ends));
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);  // in the C locale, which nothing here changes
  const auto length = end - text.c_str();
  return {first + length, length == 0 ? std::errc::invalid_argument : std::errc{}};
#endif
}

}  // namespace craze
