#include "craze/base/name_pattern.h"

#include <cstddef>

namespace craze {

namespace {

/// Where the letter after the one at `i` begins.
std::size_t after_letter(std::string_view text, std::size_t i) {
  do ++i;
  while (i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80);
  return i;
}

}  // namespace

bool fits_pattern(std::string_view name, std::string_view pattern) {
  std::size_t i = 0, p = 0;
  std::size_t star = std::string_view::npos,
              tried = 0;  // the last *, and where it ends in the name
  while (i < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      tried = i;
    } else if (p < pattern.size() && pattern[p] == '?') {
      i = after_letter(name, i);
      ++p;
    } else if (p < pattern.size() && pattern[p] == name[i]) {
      ++i;
      ++p;
    } else if (star != std::string_view::npos) {
      i = tried = after_letter(name, tried);
      p = star + 1;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace craze
