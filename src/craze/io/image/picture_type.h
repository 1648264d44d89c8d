// What kind of picture some bytes are.
#pragma once

#include <string>
#include <string_view>

namespace craze {

/// The media type that the first bytes tell; "" where they do not.
std::string picture_type(std::string_view bytes);

}  // namespace craze
