// Pictures that are broken, found without decoding them.
#pragma once

#include <string>
#include <string_view>

namespace craze {

/// Why no program can show these bytes as the PNG or JPEG that they begin as, such as "it is cut
/// off"; "" where nothing speaks against it, or they are of a kind that is not known here.
std::string picture_fault(std::string_view bytes);

}  // namespace craze
