// "Did you mean …?"
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace craze {

/// Insertions, deletions, replacements and swaps of neighbours that turn a into b.
int edit_distance(std::string_view a, std::string_view b);

/// The name most like `given`, or "" where none is near enough to be meant. Of dotted names, one
/// with the same or nearly the same last part is near whatever precedes it. Ties go to the first.
std::string nearest_name(const std::string& given, const std::vector<std::string>& names);

}  // namespace craze
