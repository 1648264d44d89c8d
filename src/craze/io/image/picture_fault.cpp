// Formats: ISO/IEC 15948:2004, 5.3; ITU-T T.81, annex B.
#include "craze/io/image/picture_fault.h"

#include <cstdint>

#include "craze/io/bytes/crc32.h"
#include "craze/io/image/picture_type.h"
#include "craze/io/image/png_chunks.h"

namespace craze {

namespace {

constexpr const char* cut_off = "it is cut off";

std::uint32_t big(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t x = 0;
  for (std::size_t i = 0; i < count; ++i) x = x << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return x;
}

std::string png_fault(std::string_view bytes) {
  if (!bytes.starts_with(png_signature)) return "its first bytes are damaged";
  bool has_size = false, has_pixels = false;
  for (std::size_t at = png_signature.size(); at < bytes.size();) {
    constexpr std::size_t around = 12;  // length, type and checksum
    if (bytes.size() - at < around) return cut_off;
    const std::size_t length = big(bytes, at, 4);
    if (length > bytes.size() - at - around) return cut_off;
    const std::string_view type = bytes.substr(at + 4, 4);
    if (!has_size && (type != "IHDR" || length != 13)) return "it does not say its size";
    if (crc32(bytes.substr(at + 4, length + 4)) != big(bytes, at + 8 + length, 4)) {
      return "its bytes are damaged";
    }
    has_size = true;
    has_pixels = has_pixels || type == "IDAT";
    if (type == "IEND") return has_pixels ? "" : "it has no pixels";
    at += length + around;
  }
  return cut_off;
}

std::string jpeg_fault(std::string_view bytes) {
  constexpr std::uint8_t frame_first = 0xC0, frame_last = 0xCF, tables = 0xC4, arithmetic = 0xCC,
                         extension = 0xC8, scan = 0xDA;
  bool has_size = false;
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    if (static_cast<std::uint8_t>(bytes[at]) != 0xFF) return "its bytes are damaged";
    const auto marker = static_cast<std::uint8_t>(bytes[at + 1]);
    if (marker == 0xFF) {  // fills
      ++at;
      continue;
    }
    const std::size_t length = big(bytes, at + 2, 2);
    if (length < 2) return "its bytes are damaged";
    has_size = has_size || (marker >= frame_first && marker <= frame_last && marker != tables &&
                            marker != arithmetic && marker != extension);
    if (marker == scan) {
      if (!has_size) return "it does not say its size";
      const std::string_view end("\xFF\xD9", 2);
      return bytes.find(end, at) == std::string_view::npos ? cut_off : "";
    }
    at += 2 + length;
  }
  return cut_off;
}

}  // namespace

std::string picture_fault(std::string_view bytes) {
  if (bytes.empty()) return "it has no bytes";
  const std::string type = picture_type(bytes);
  if (type == "image/png") return png_fault(bytes);
  if (type == "image/jpeg") return jpeg_fault(bytes);
  return type.empty() ? "it is no picture that is known" : "";
}

}  // namespace craze
