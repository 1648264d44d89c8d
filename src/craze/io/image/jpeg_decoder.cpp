// Format: ITU-T T.81, read by libjpeg. Built with CRAZE_JPEG where that is there.
#include "craze/io/image/image_codecs.h"
#include "craze/io/image/image_size.h"

#ifdef CRAZE_JPEG
#include <cstdio>  // before jpeglib.h, which uses FILE

#include <jpeglib.h>

#include <jerror.h>

#include <csetjmp>
#endif

namespace craze {

bool is_jpeg(std::string_view bytes) {
  return bytes.starts_with("\xff\xd8\xff");
}

#ifdef CRAZE_JPEG

namespace {

/// A block of 64 pixels takes at least one bit of a Huffman code. Arithmetic codes take less; the
/// bound there is only one on memory.
constexpr std::uint64_t pixels_per_huffman_byte = 64 * 8, pixels_per_arithmetic_byte = 1 << 16;
/// A progressive file may scan a large picture many times over.
constexpr int most_scans = 100;

/// One run of libjpeg. Its errors come back by longjmp, so whatever needs a destructor lives here
/// and not in the function that is jumped out of.
struct JpegDecoder {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  std::jmp_buf on_error{};
  char why[JMSG_LENGTH_MAX] = "";

  JpegDecoder() {
    jpeg.err = jpeg_std_error(&errors);
    jpeg.client_data = this;
    errors.error_exit = [](j_common_ptr common) {
      auto* self = static_cast<JpegDecoder*>(common->client_data);
      common->err->format_message(common, self->why);
      std::longjmp(self->on_error, 1);
    };
    // A warning means damage, and nothing is made up for what is missing; but bytes too many harm
    // nothing.
    errors.emit_message = [](j_common_ptr common, int level) {
      const bool is_damage = level < 0 && common->err->msg_code != JWRN_EXTRANEOUS_DATA;
      if (is_damage) common->err->error_exit(common);
    };
  }
  JpegDecoder(const JpegDecoder&) = delete;
  JpegDecoder& operator=(const JpegDecoder&) = delete;
  ~JpegDecoder() { jpeg_destroy_decompress(&jpeg); }

  bool read_header(std::string_view bytes) {
    if (setjmp(on_error) != 0) return false;
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()),
                 static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&jpeg, TRUE);
    // Inks of print (CMYK, YCCK) are not colours of light; libjpeg refuses to turn them into RGB.
    jpeg.out_color_space = jpeg.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg.dct_method = JDCT_ISLOW;
    return true;
  }

  bool read_pixels(unsigned char* first) {
    if (setjmp(on_error) != 0) return false;
    jpeg_start_decompress(&jpeg);
    const std::size_t stride =
        std::size_t{jpeg.output_width} * static_cast<std::size_t>(jpeg.output_components);
    while (jpeg.output_scanline < jpeg.output_height) {
      unsigned char* row = first + jpeg.output_scanline * stride;
      jpeg_read_scanlines(&jpeg, &row, 1);
      if (jpeg.input_scan_number > most_scans) return false;
    }
    jpeg_finish_decompress(&jpeg);
    return true;
  }
};

}  // namespace

Image decode_jpeg(std::string_view bytes, const std::string& name) {
  JpegDecoder decoder;
  if (!decoder.read_header(bytes)) fail_image(name, decoder.why);
  check_image_size(decoder.jpeg.image_width, decoder.jpeg.image_height, bytes.size(),
                   decoder.jpeg.arith_code ? pixels_per_arithmetic_byte : pixels_per_huffman_byte,
                   name);
  Image image;
  image.width = static_cast<std::int32_t>(decoder.jpeg.image_width);
  image.height = static_cast<std::int32_t>(decoder.jpeg.image_height);
  image.channels = decoder.jpeg.num_components == 1 ? 1 : 3;
  std::vector<std::uint8_t> values(static_cast<std::size_t>(image.width) *
                                   static_cast<std::size_t>(image.height) *
                                   static_cast<std::size_t>(image.channels));
  if (!decoder.read_pixels(values.data())) fail_image(name, decoder.why);
  image.values = std::move(values);
  return image;
}

#else

Image decode_jpeg(std::string_view, const std::string& name) {
  fail_image(name, "this build of craze reads no JPEG");
}

#endif

}  // namespace craze
