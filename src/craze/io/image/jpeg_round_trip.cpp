#include "craze/io/image/jpeg_round_trip.h"

#include "craze/error.h"

#ifdef CRAZE_JPEG
#include <cstdio>  // before jpeglib.h, which uses FILE

#include <jpeglib.h>

#include <csetjmp>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <variant>

#include "craze/io/image/image_codecs.h"
#endif

namespace craze {

#ifdef CRAZE_JPEG

namespace {

struct Encoder {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  std::jmp_buf on_error{};
  unsigned char* bytes = nullptr;  // libjpeg's
  unsigned long size = 0;          // NOLINT(google-runtime-int): libjpeg's type

  Encoder() {
    jpeg.err = jpeg_std_error(&errors);
    jpeg.client_data = this;
    errors.error_exit = [](j_common_ptr common) {
      std::longjmp(static_cast<Encoder*>(common->client_data)->on_error, 1);
    };
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  ~Encoder() {
    jpeg_destroy_compress(&jpeg);
    std::free(bytes);
  }

  /// libjpeg reports errors by a long jump, so nothing here has a destructor.
  bool encode(int width, int height, std::uint8_t* rgb, int quality) {
    if (setjmp(on_error) != 0) return false;
    jpeg_create_compress(&jpeg);
    jpeg_mem_dest(&jpeg, &bytes, &size);
    jpeg.image_width = static_cast<JDIMENSION>(width);
    jpeg.image_height = static_cast<JDIMENSION>(height);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, quality, TRUE);
    jpeg.dct_method = JDCT_ISLOW;  // in whole numbers: the same on every machine
    jpeg_start_compress(&jpeg, TRUE);
    while (jpeg.next_scanline < jpeg.image_height) {
      JSAMPROW row = rgb + static_cast<std::size_t>(jpeg.next_scanline) * width * 3;
      jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    return true;
  }
};

}  // namespace

void jpeg_round_trip(int width, int height, std::vector<std::uint8_t>& rgb, int quality) {
  Encoder encoder;
  if (!encoder.encode(width, height, rgb.data(), quality)) throw std::bad_alloc();
  const std::string_view bytes(reinterpret_cast<const char*>(encoder.bytes), encoder.size);
  rgb = std::get<std::vector<std::uint8_t>>(decode_jpeg(bytes, "a packed picture").values);
}

#else

void jpeg_round_trip(int, int, std::vector<std::uint8_t>&, int) {
  throw Error(ErrorKind::request, "cannot pack a picture", "image.quality",
              "this build has no JPEG; leave it at 100");
}

#endif

}  // namespace craze
