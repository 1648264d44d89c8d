#include "craze/io/image/image_size.h"

#include "craze/error.h"

namespace craze {

namespace {

constexpr std::uint64_t most_pixels = std::uint64_t{1} << 26;

}  // namespace

void fail_image(const std::string& name, const std::string& why) {
  throw Error(ErrorKind::input, "cannot read picture", name, why);
}

void check_image_size(std::uint32_t width, std::uint32_t height, std::size_t bytes,
                      std::uint64_t pixels_per_byte, const std::string& name) {
  if (width > largest_side || height > largest_side) {
    fail_image(name, "it is more than 16,384 pixels wide or high");
  }
  const std::uint64_t pixels = std::uint64_t{width} * height;
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  if (pixels == 0) fail_image(name, "it has no pixels");
  if (pixels > most_pixels) fail_image(name, "it is too large: " + size + " pixels");
  if (pixels / pixels_per_byte > bytes) fail_image(name, "the file is too short for " + size);
}

}  // namespace craze
