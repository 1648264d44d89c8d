// Pictures as PNG, in memory.
#pragma once

#include <string>

#include "craze/base/image.h"

namespace craze {

/// A PNG of 8 bits a channel, numbers as they are; the same bytes on every machine with the same
/// zlib. The image's numbers are of 8 bits. Throws Error(request) where the build has no zlib.
std::string encode_png(const Image& image);

}  // namespace craze
