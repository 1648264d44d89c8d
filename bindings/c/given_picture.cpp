#include "given_picture.h"

#include "craze/base/image.h"
#include "guard.h"

namespace craze::c {

namespace {

template <class T>
std::vector<T> copy_pixels(const void* pixels, int64_t count) {
  const T* first = static_cast<const T*>(pixels);
  return {first, first + count};
}

decltype(Image::values) pixel_values(const void* pixels, craze_type type, int64_t count,
                                     const char* name) {
  switch (type) {
    case CRAZE_UINT8:
      return copy_pixels<std::uint8_t>(pixels, count);
    case CRAZE_UINT16:
      return copy_pixels<std::uint16_t>(pixels, count);
    case CRAZE_FLOAT32: {
      std::vector<float> values = copy_pixels<float>(pixels, count);
      for (const float x : values) {
        if (!(x >= 0 && x <= 1)) {
          throw Error(ErrorKind::usage, "wrong pixel", name, "must be in [0, 1]");
        }
      }
      return values;
    }
    default:
      throw Error(ErrorKind::usage, "wrong type of pixels", name,
                  "must be CRAZE_UINT8, CRAZE_UINT16 or CRAZE_FLOAT32");
  }
}

}  // namespace

GreyImage grey_picture(const void* pixels, craze_type type, int64_t width, int64_t height,
                       int32_t channels, const char* name) {
  require(pixels, "pixels");
  constexpr int64_t longest = 16384;
  if (width < 1 || height < 1 || width > longest || height > longest) {
    throw Error(ErrorKind::usage, "wrong size of a picture", name,
                "its sides must be 1 to 16384 pixels");
  }
  if (channels < 1 || channels > 4) {
    throw Error(ErrorKind::usage, "wrong number of channels", name, "must be 1 to 4");
  }
  Image image;
  image.width = static_cast<std::int32_t>(width);
  image.height = static_cast<std::int32_t>(height);
  image.channels = channels;
  image.values = pixel_values(pixels, type, width * height * channels, name);
  return to_grey(image);
}

}  // namespace craze::c
