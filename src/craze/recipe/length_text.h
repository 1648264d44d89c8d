// Lengths with units as text: "4mm", "0.5in", "3%".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "craze/length.h"

namespace craze {

/// What a number may end in, in the order of LengthUnit from micrometre on: "um", "mm", … "%".
const std::vector<std::string>& length_suffixes();

/// How many metres the unit is; 0 for `own` and `percent`, which are no fixed lengths.
double metres(LengthUnit unit);

/// A number and, right behind it, its unit; without one it is bare. None where the text is anything
/// else. A number too large for a double comes out infinite.
std::optional<Length> parse_length(std::string_view text);

/// The shortest text that parse_length reads back as the same length.
std::string format_length(const Length& length);

}  // namespace craze
