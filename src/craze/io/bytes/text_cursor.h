// Walks through a text held in memory: words, numbers, lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace craze {

/// A position in a text. Lines end with \n, \r or both; a backslash before the line's end joins the
/// next line and ends a word; `#` starts a comment that runs to the end of the line. Nothing is
/// allocated but messages.
class TextCursor {
 public:
  /// Both must outlive the cursor. `name` is the file's, for messages; `line` the number of the
  /// text's first line.
  TextCursor(std::string_view text, const std::string& name, std::size_t line = 1)
      : begin_(text.data()),
        at_(text.data()),
        end_(text.data() + text.size()),
        name_(&name),
        line_(line) {}

  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
  std::size_t line() const { return line_; }

  /// Moves to the next word of this or a later line; false where none is left.
  bool skip_blank();
  /// Moves to the next word of this line; false where none is left.
  bool more_on_line();
  /// Moves to the start of the next line that does not continue this one.
  void skip_line();

  /// The word here, up to a space or the end of the line; empty where there is none.
  std::string_view word();
  /// The rest of the line without the spaces around it; comments are kept.
  std::string_view rest_of_line();
  /// A finite number, the next word of this line. Fails, naming `what`, where there is none.
  double number(const char* what);
  /// The same, which may be infinite or "nan".
  double any_number(const char* what);
  /// A whole number, the next word of this line.
  std::int64_t integer(const char* what);
  /// A whole number at this very byte, which may be followed by `/` (OBJ's corners).
  std::int64_t leading_integer(const char* what);
  /// Steps over c if it stands here.
  bool accept(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  bool is_at(char c) const { return at_ != end_ && *at_ == c; }

  /// True at a space, at the end of a line and at the end of the text.
  bool at_word_end() const { return ends_word(at_); }

  /// Throws Error(input) at this line.
  [[noreturn]] void fail(const std::string& why) const;

 private:
  static bool is_newline(char c) { return c == '\n' || c == '\r'; }
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  bool is_continuation(const char* p) const {
    return *p == '\\' && p + 1 != end_ && is_newline(p[1]);
  }
  bool ends_word(const char* p) const {
    return p == end_ || is_space(*p) || is_newline(*p) || is_continuation(p);
  }
  void step_over_newline();
  std::string_view word_here() const;
  /// Past a plus sign, which numbers may have here but not in the standard library.
  const char* after_plus(const char* p) const;

  const char* begin_;
  const char* at_;
  const char* end_;
  const std::string* name_;
  std::size_t line_;
};

}  // namespace craze
