// The words of USDA: identifiers, strings, arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace craze {

/// Identifiers of one scope: letters, digits and underscores, no digit first, none twice.
class UsdNames {
 public:
  /// `name` itself where it is one and is free.
  std::string take(std::string_view name);

 private:
  std::set<std::string> taken_;
};

/// In double quotes, on one line, what is no UTF-8 as U+FFFD.
std::string usd_string(std::string_view text);

/// A path between @ signs, three of them where it has one itself; no control characters.
std::string usd_asset(std::string_view path);

/// "[a, b, …]": `append(out, i)` writes element i.
template <class Append>
void append_usd_array(std::string& out, std::size_t count, Append append) {
  out += '[';
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out += ", ";
    append(out, i);
  }
  out += ']';
}

/// Numbers that float and int hold, as short as they round-trip. USD reads inf and nan as well.
void append_usd_number(std::string& out, float number);
void append_usd_number(std::string& out, double number);
void append_usd_number(std::string& out, std::int32_t number);

/// "(x, y, …)", or the number alone where there is one.
template <class Number>
void append_usd_tuple(std::string& out, const Number* numbers, int n) {
  if (n > 1) out += '(';
  for (int k = 0; k < n; ++k) {
    if (k > 0) out += ", ";
    append_usd_number(out, numbers[k]);
  }
  if (n > 1) out += ')';
}

}  // namespace craze
