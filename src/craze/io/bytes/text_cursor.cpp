#include "craze/io/bytes/text_cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "craze/base/parse_double.h"
#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"

namespace craze {

namespace {

/// What a number is that no double can hold: infinite or 0, by its power of ten.
double beyond_double(std::string_view text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = std::min(mantissa.find_first_of("123456789"), mantissa.size());
  // Of digits before the first that counts, or after the point.
  const double digits = static_cast<double>(point) - static_cast<double>(first);
  double power = 0;
  if (e < text.size()) {
    for (const char c : text.substr(e + 1)) {
      if (c >= '0' && c <= '9') power = 10 * power + (c - '0');
    }
    if (text.substr(e + 1).starts_with('-')) power = -power;
  }
  return power + digits > 0 ? std::numeric_limits<double>::infinity() : 0;
}

}  // namespace

void TextCursor::fail(const std::string& why) const {
  fail_input(at_line(*name_, line_), why);
}

void TextCursor::step_over_newline() {
  if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
  ++at_;
  ++line_;
}

bool TextCursor::more_on_line() {
  while (at_ != end_) {
    if (is_space(*at_)) {
      ++at_;
    } else if (is_continuation(at_)) {
      ++at_;
      step_over_newline();
    } else {
      return !is_newline(*at_) && *at_ != '#';
    }
  }
  return false;
}

bool TextCursor::skip_blank() {
  while (!more_on_line()) {
    if (at_ == end_) return false;
    skip_line();
  }
  return true;
}

void TextCursor::skip_line() {
  bool in_comment = false;
  while (at_ != end_ && !is_newline(*at_)) {
    in_comment = in_comment || *at_ == '#';
    const bool joins = !in_comment && is_continuation(at_);
    ++at_;
    if (joins) step_over_newline();
  }
  if (at_ != end_) step_over_newline();
}

std::string_view TextCursor::word_here() const {
  const char* p = at_;
  while (!ends_word(p)) ++p;
  return {at_, static_cast<std::size_t>(p - at_)};
}

std::string_view TextCursor::word() {
  const std::string_view w = word_here();
  at_ += w.size();
  return w;
}

std::string_view TextCursor::rest_of_line() {
  while (at_ != end_ && is_space(*at_)) ++at_;
  const char* first = at_;
  while (at_ != end_ && !is_newline(*at_)) ++at_;
  const char* last = at_;
  while (last != first && is_space(last[-1])) --last;
  return {first, static_cast<std::size_t>(last - first)};
}

const char* TextCursor::after_plus(const char* p) const {
  const bool is_sign = p != end_ && *p == '+' && (p + 1 == end_ || p[1] != '-');
  return is_sign ? p + 1 : p;
}

double TextCursor::number(const char* what) {
  const TextCursor start = *this;
  const double value = any_number(what);
  if (!std::isfinite(value)) {
    *this = start;
    more_on_line();
    fail(fmt::format("{} '{}' is not a finite number", what, printable(word_here())));
  }
  return value;
}

double TextCursor::any_number(const char* what) {
  if (!more_on_line()) fail(fmt::format("{} is missing", what));
  const char* first = after_plus(at_);
  double value = 0;
  auto [last, status] = parse_double(first, end_, value);
  if (status == std::errc{} && last != end_ && *last == '#' && last[-1] == '.') {
    value = std::numeric_limits<double>::quiet_NaN();  // "1.#QNAN", "-1.#IND", "1.#INF"
    while (!ends_word(last)) ++last;
  }
  if (status == std::errc::invalid_argument || !ends_word(last)) {
    fail(fmt::format("{} '{}' is not a number", what, printable(word_here())));
  }
  if (status == std::errc::result_out_of_range) {
    value = beyond_double({first, static_cast<std::size_t>(last - first)});
  }
  at_ = last;
  return value;
}

std::int64_t TextCursor::integer(const char* what) {
  if (!more_on_line()) fail(fmt::format("{} is missing", what));
  const char* start = at_;
  const std::int64_t value = leading_integer(what);
  if (!ends_word(at_)) {
    at_ = start;
    fail(fmt::format("{} '{}' is not a whole number", what, printable(word_here())));
  }
  return value;
}

std::int64_t TextCursor::leading_integer(const char* what) {
  const char* first = after_plus(at_);
  std::int64_t value = 0;
  const auto [last, status] = std::from_chars(first, end_, value);
  if (status != std::errc{}) {
    fail(fmt::format("{} '{}' is not a whole number", what, printable(word_here())));
  }
  at_ = last;
  return value;
}

}  // namespace craze
