// Whether people or programs read what the command says on standard error.
#pragma once

namespace craze::app {

enum class MessageStyle {
  line,  ///< words, and one line of progress on a terminal
  json,  ///< one JSON object a line, and nothing else
};

/// What the arguments of main() ask for by --progress, found without reading the rest of them: an
/// error in those is said in that style too.
MessageStyle message_style(int argc, const char* const* argv);

}  // namespace craze::app
