// The lines of a material library and the words on them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace craze {

/// The text's lines, however they end; those that a backslash joins are one.
std::vector<std::string> mtl_lines(std::string_view text);

/// Takes the first word off a text, whose rest has no blanks around it.
std::string_view take_mtl_word(std::string_view& text);

/// A finite number that is the whole word, whatever the program's locale.
std::optional<double> mtl_number(std::string_view word);

/// What is said of a picture.
struct MtlPicture {
  std::string name;                                ///< with / between folders; "": none
  std::array<double, 2> scale{1, 1}, shift{0, 0};  ///< of the UVs: -s, then -o
  bool is_clamped = false;                         ///< -clamp: it does not repeat
  double strength = 1;                             ///< -bm
};

/// What follows the keyword of a picture's line.
MtlPicture parse_mtl_picture(std::string_view rest);

/// The name alone, as it stands there.
std::string_view mtl_picture_name(std::string_view rest);

}  // namespace craze
