// A recipe as JSON, read as the TOML it stands for.
#pragma once

#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace craze {

/// Whether a text is JSON rather than TOML: its first character that is not white space is "{".
bool is_json(std::string_view text);

/// Objects become tables, everything else itself. `what` is the word for what it should be,
/// "recipe". Throws Error(usage) naming `name` for what is not JSON, nested deeper than any recipe
/// needs, or null.
toml::table read_json_table(std::string_view text, const std::string& name,
                            const std::string& what);

}  // namespace craze
