#include "color_option.h"

#include "craze/error.h"

namespace craze::app {

std::array<int, 3> color_of(const std::string& option, const std::string& text) {
  const std::string digits = text.starts_with('#') ? text.substr(1) : text;
  const bool hexadecimal =
      digits.size() == 6 && digits.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
  if (!hexadecimal) {
    throw Error(ErrorKind::usage, "wrong colour", option + " " + text,
                "six hexadecimal digits are wanted, such as 606a78");
  }
  const int rgb = std::stoi(digits, nullptr, 16);
  return {rgb >> 16, rgb >> 8 & 255, rgb & 255};
}

}  // namespace craze::app
