// The errors of readers: which file, which line, and why, on one line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace craze {

/// Throws Error(input) "cannot read mesh (WHERE): WHY".
[[noreturn]] void fail_input(const std::string& where, const std::string& why);

/// "NAME:LINE".
std::string at_line(const std::string& name, std::size_t line);

/// Bytes of a file as they may appear in a message: UTF-8 without control
/// characters, any other byte a question mark, cut after 40 characters.
std::string printable(std::string_view bytes);

}  // namespace craze
