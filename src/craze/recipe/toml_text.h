// TOML from outside: refused in one line where it is none.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace craze {

/// Larger texts are refused, bytes.
inline constexpr std::size_t toml_size_limit = std::size_t{1} << 20;

/// The table of a TOML text, or of a JSON text (json_table.h). `name` is the file named in errors,
/// `what` the word for what it should be, "recipe". Throws Error(usage) with the place.
toml::table parse_toml(std::string_view text, const std::string& name, const std::string& what);

/// The TOML library limits nested values, but nests one table per dot of a key and takes the stack
/// with it when they are freed. Keys here have few dots; a run of more than any needs is refused
/// wherever it stands: Error(usage).
void check_toml_nesting(std::string_view text, const std::string& name, const std::string& what);

/// Something in a text that is no TOML.
struct TomlFault {
  std::size_t at;   ///< bytes from the start
  const char* why;  ///< one line
};

/// The first of what the TOML library must not see, as it takes it for what cannot be and its
/// behaviour is undefined then: characters that are not ASCII outside quotes and comments (its test
/// for white space has no answer for some), and headers that do not begin with a key.
std::optional<TomlFault> find_toml_fault(std::string_view toml);

}  // namespace craze
