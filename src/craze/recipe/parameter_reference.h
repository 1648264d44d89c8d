// The parameter table as text to read.
#pragma once

#include <string>

namespace craze {

/// For a terminal: one or two lines a parameter.
std::string parameter_listing();

/// The page docs/reference.md, in Markdown.
std::string parameter_page();

}  // namespace craze
