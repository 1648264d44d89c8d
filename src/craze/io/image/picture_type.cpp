#include "craze/io/image/picture_type.h"

namespace craze {

std::string picture_type(std::string_view bytes) {
  const auto at = [&](std::size_t from, std::string_view mark) {
    return bytes.size() >= from + mark.size() && bytes.substr(from, mark.size()) == mark;
  };
  if (at(0, "\x89PNG")) return "image/png";
  if (at(0, "\xFF\xD8\xFF")) return "image/jpeg";
  if (at(0, "\xABKTX 20")) return "image/ktx2";
  if (at(0, "RIFF") && at(8, "WEBP")) return "image/webp";
  if (at(4, "ftypavif")) return "image/avif";
  return "";
}

}  // namespace craze
