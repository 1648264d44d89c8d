// A plan's text with other numbers at its top level, and else byte for byte the same.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace craze {

/// The text with `key = value` in place of its own, or, where it has none, in a line in front.
/// JSON is written anew. `name` is the file named in errors. Throws Error(usage) where the text is
/// no TOML.
std::string with_number(const std::string& text, const std::string& name, const std::string& key,
                        std::uint64_t value);

/// The text without the lines that give these keys. JSON is written anew. Throws as with_number.
std::string without_keys(const std::string& text, const std::string& name,
                         const std::vector<std::string>& keys);

}  // namespace craze
