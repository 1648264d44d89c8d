#include "craze/recipe/nearest_name.h"

#include <algorithm>

namespace craze {

namespace {

// Longer than any name; keeps hostile input from costing a long comparison.
constexpr std::size_t longest = 64;

std::string_view last_part(std::string_view name) {
  return name.substr(name.rfind('.') + 1);
}

bool is_near(int distance, std::size_t length) {
  return distance <= std::max(1, static_cast<int>(length) / 3);
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min(
          {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

std::string nearest_name(const std::string& given, const std::vector<std::string>& names) {
  if (given.size() > longest) return "";
  std::string nearest;
  int least = 1000;
  for (const std::string& name : names) {
    const int whole = edit_distance(given, name);
    // A right name in the wrong place costs as much as one wrong letter.
    const int part = edit_distance(last_part(given), last_part(name)) + 1;
    if (is_near(whole, given.size()) && whole < least) {
      least = whole;
      nearest = name;
    }
    if (is_near(part - 1, last_part(given).size()) && part < least) {
      least = part;
      nearest = name;
    }
  }
  return nearest;
}

}  // namespace craze
