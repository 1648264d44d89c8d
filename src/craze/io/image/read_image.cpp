#include "craze/io/image/read_image.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <fstream>
#include <iterator>

#include "craze/base/error.h"

namespace craze {

namespace {

constexpr std::uint32_t largest_side = 16384;
constexpr std::uint64_t most_pixels = std::uint64_t{1} << 26;
constexpr png_alloc_size_t largest_chunk = 1 << 24;
constexpr std::uint64_t deflate_ratio = 1032;  // no stream of deflate packs more tightly
constexpr std::size_t signature_length = 8;

[[noreturn]] void fail(const std::string& name, const std::string& why) {
  throw Error(ErrorKind::input, "cannot read picture", name, why);
}

/// One run of libpng. Its errors come back by longjmp, so whatever needs a destructor lives here
/// and not in the function that is jumped out of.
struct Decoder {
  std::string_view bytes;
  std::size_t position = 0;
  std::string why;
  png_structp png = nullptr;
  png_infop info = nullptr;
  int channels = 0, depth = 0, passes = 0;
  GreyImage image;
  std::vector<png_byte> rows;

  explicit Decoder(std::string_view b) : bytes(b) {}
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }

  static void on_error(png_structp png, png_const_charp message) {
    static_cast<Decoder*>(png_get_error_ptr(png))->why = message;
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}
  static void on_read(png_structp png, png_bytep to, std::size_t n) {
    auto* self = static_cast<Decoder*>(png_get_io_ptr(png));
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
    const png_uint_32 width = png_get_image_width(png, info);
    const png_uint_32 height = png_get_image_height(png, info);
    if (width > largest_side || height > largest_side) {
      png_error(png, "it is more than 16,384 pixels wide or high");
    }
    image.width = static_cast<std::int32_t>(width);
    image.height = static_cast<std::int32_t>(height);
    png_set_expand(png);
    passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    channels = png_get_channels(png, info);
    depth = png_get_bit_depth(png, info);
    return true;
  }

  /// Rows are taken one by one, or all at once where interlacing needs several passes.
  bool read_pixels() {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    const std::size_t stride = png_get_rowbytes(png, info);
    for (int pass = 0; pass < passes; ++pass) {
      for (std::int32_t y = 0; y < image.height; ++y) {
        png_bytep row = rows.data() + (passes > 1 ? y * stride : 0);
        png_read_row(png, row, nullptr);
        if (pass + 1 == passes) to_grey(row, y);
      }
    }
    return true;
  }

  void to_grey(const png_byte* row, std::int32_t y) {
    const int sample_bytes = depth / 8;
    const auto sample = [&](std::int32_t x, int channel) -> double {
      const png_byte* p = row + (static_cast<std::size_t>(x) * channels + channel) * sample_bytes;
      return depth == 16 ? (256 * p[0] + p[1]) / 65535.0 : p[0] / 255.0;
    };
    float* grey = image.pixels.data() + static_cast<std::size_t>(y) * image.width;
    for (std::int32_t x = 0; x < image.width; ++x) {
      const double value =
          channels < 3 ? sample(x, 0)
                       : 0.2126 * sample(x, 0) + 0.7152 * sample(x, 1) + 0.0722 * sample(x, 2);
      grey[x] = static_cast<float>(value);
    }
  }
};

}  // namespace

GreyImage decode_png(std::string_view bytes, const std::string& name) {
  const std::size_t head = std::min(bytes.size(), signature_length);
  if (head < signature_length ||
      png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, head) != 0) {
    fail(name, "it is not a PNG file");
  }
  Decoder decoder(bytes);
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, Decoder::on_error,
                                       Decoder::on_warning);
  decoder.info = decoder.png ? png_create_info_struct(decoder.png) : nullptr;
  if (!decoder.info) fail(name, "out of memory");
  if (!decoder.read_header()) fail(name, decoder.why);

  const std::uint64_t pixels = static_cast<std::uint64_t>(decoder.image.width) *
                               static_cast<std::uint64_t>(decoder.image.height);
  const std::string size =
      std::to_string(decoder.image.width) + " x " + std::to_string(decoder.image.height);
  if (pixels > most_pixels) fail(name, "it is too large: " + size + " pixels");
  // Even one bit a pixel cannot be packed more tightly: do not reserve memory for a lie.
  if (pixels / 8 / deflate_ratio > bytes.size()) fail(name, "the file is too short for " + size);
  const std::size_t stride = png_get_rowbytes(decoder.png, decoder.info);
  decoder.rows.resize(stride * (decoder.passes > 1 ? decoder.image.height : 1));
  decoder.image.pixels.resize(pixels);
  if (!decoder.read_pixels()) fail(name, decoder.why);
  return std::move(decoder.image);
}

GreyImage read_image(const std::filesystem::path& path) {
  std::error_code code;
  if (!std::filesystem::exists(path, code)) fail(path.string(), "there is no such file");
  if (!std::filesystem::is_regular_file(path, code)) fail(path.string(), "it is not a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path.string(), "it cannot be opened");
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) fail(path.string(), "it cannot be read to its end");
  return decode_png(bytes, path.string());
}

}  // namespace craze
