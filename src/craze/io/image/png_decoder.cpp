// Format: ISO/IEC 15948:2004, read by libpng. Built with CRAZE_PNG where that is there.
#include <cstring>

#include "craze/io/image/image_codecs.h"
#include "craze/io/image/image_size.h"

#ifdef CRAZE_PNG
#include <png.h>

#include <csetjmp>
#endif

namespace craze {

bool is_png(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1a\n");
}

#ifdef CRAZE_PNG

namespace {

constexpr png_alloc_size_t largest_chunk = 1 << 24;
/// No stream of deflate packs more tightly, and a byte holds eight pixels of one bit.
constexpr std::uint64_t pixels_per_deflated_byte = 8 * 1032;

/// One run of libpng. Its errors come back by longjmp, so whatever needs a destructor lives here
/// and not in the function that is jumped out of.
struct PngDecoder {
  std::string_view bytes;
  std::size_t position = 0;
  std::string why;
  png_structp png = nullptr;
  png_infop info = nullptr;
  png_uint_32 width = 0, height = 0;
  int channels = 0, depth = 0, passes = 0;

  explicit PngDecoder(std::string_view b) : bytes(b) {}
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;
  ~PngDecoder() { png_destroy_read_struct(&png, &info, nullptr); }

  static void on_error(png_structp png, png_const_charp message) {
    static_cast<PngDecoder*>(png_get_error_ptr(png))->why = message;
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}
  static void on_read(png_structp png, png_bytep to, std::size_t n) {
    auto* self = static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (n > self->bytes.size() - self->position) png_error(png, "the file ends too early");
    std::memcpy(to, self->bytes.data() + self->position, n);
    self->position += n;
  }

  bool read_header() {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // ours follow, with a clear reason
    png_set_chunk_malloc_max(png, largest_chunk);
    png_set_read_fn(png, this, on_read);
    png_read_info(png, info);
    width = png_get_image_width(png, info);
    height = png_get_image_height(png, info);
    if (width > largest_side || height > largest_side) return true;  // refused by the caller
    png_set_expand(png);
    passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    channels = png_get_channels(png, info);
    depth = png_get_bit_depth(png, info);
    return true;
  }

  /// Each row of a pass over the whole picture goes to `first` + y · `stride`.
  bool read_pixels(png_bytep first) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    const std::size_t stride = png_get_rowbytes(png, info);
    for (int pass = 0; pass < passes; ++pass) {
      for (png_uint_32 y = 0; y < height; ++y) png_read_row(png, first + y * stride, nullptr);
    }
    return true;
  }
};

/// Samples of two bytes, the higher first, become numbers in place.
void join_bytes(std::vector<std::uint16_t>& samples) {
  for (std::uint16_t& sample : samples) {
    unsigned char pair[2];
    std::memcpy(pair, &sample, 2);
    sample = static_cast<std::uint16_t>(256 * pair[0] + pair[1]);
  }
}

}  // namespace

Image decode_png(std::string_view bytes, const std::string& name) {
  PngDecoder decoder(bytes);
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, PngDecoder::on_error,
                                       PngDecoder::on_warning);
  decoder.info = decoder.png ? png_create_info_struct(decoder.png) : nullptr;
  if (!decoder.info) fail_image(name, "out of memory");
  if (!decoder.read_header()) fail_image(name, decoder.why);
  check_image_size(decoder.width, decoder.height, bytes.size(), pixels_per_deflated_byte, name);

  Image image;
  image.width = static_cast<std::int32_t>(decoder.width);
  image.height = static_cast<std::int32_t>(decoder.height);
  image.channels = decoder.channels;
  const std::size_t samples = png_get_rowbytes(decoder.png, decoder.info) * decoder.height * 8 /
                              static_cast<std::size_t>(decoder.depth);
  bool whole = false;
  if (decoder.depth == 16) {
    std::vector<std::uint16_t> values(samples);
    whole = decoder.read_pixels(reinterpret_cast<png_bytep>(values.data()));
    join_bytes(values);
    image.values = std::move(values);
  } else {
    std::vector<std::uint8_t> values(samples);
    whole = decoder.read_pixels(values.data());
    image.values = std::move(values);
  }
  if (!whole) fail_image(name, decoder.why);
  return image;
}

#else

Image decode_png(std::string_view, const std::string& name) {
  fail_image(name, "this build of craze reads no PNG");
}

#endif

}  // namespace craze
