// Format: ISO/IEC 15948:2004. Written here and not by libpng, so that blocks of rows are packed by
// all threads and the picture need never be in memory: each block is a part of one deflate stream
// that depends on nothing before it.
#include <algorithm>
#include <cmath>

#include "craze/base/srgb.h"
#include "craze/io/files/new_file.h"
#include "craze/io/image/deflate.h"
#include "craze/io/image/png_chunks.h"
#include "craze/io/image/row_image.h"

namespace craze {

namespace {

constexpr int png_block_rows = 32;
constexpr std::string_view zlib_header = "\x78\x01";
constexpr int linear_gamma = 100000;  // gAMA: 1
constexpr char perceptual_intent = 0;

class Png16 : public RowImage {
 public:
  Png16(const std::filesystem::path& path, const RowImageFormat& format, const Context& context)
      : format_(format), file_(path, "cannot write map", context) {
    file_.append(png_signature);
    std::string header;
    put_big(header, static_cast<std::uint32_t>(format.width));
    put_big(header, static_cast<std::uint32_t>(format.height));
    const char color = format.channels == 3 ? 2 : 0;
    header += {16, color, 0, 0, 0};
    file_.append(png_chunk("IHDR", header));
    if (format.is_color) {
      file_.append(png_chunk("sRGB", std::string(1, perceptual_intent)));
      return;
    }
    std::string gamma;
    put_big(gamma, linear_gamma);
    file_.append(png_chunk("gAMA", gamma));
  }

  int block_rows() const override { return png_block_rows; }

  Block pack(int first, int count, const float* values) const override {
    const std::size_t pixel = 2 * static_cast<std::size_t>(format_.channels);
    const std::size_t row = 1 + pixel * static_cast<std::size_t>(format_.width);
    std::string bytes(row * static_cast<std::size_t>(count), '\0');
    std::string plain(row - 1, '\0');
    for (int y = 0; y < count; ++y) {
      for (std::size_t i = 0; i < plain.size(); i += pixel) {
        for (int c = 0; c < format_.channels; ++c) {
          const std::uint16_t number = whole(*values++, c);
          plain[i + 2 * c] = static_cast<char>(number >> 8);
          plain[i + 2 * c + 1] = static_cast<char>(number & 255);
        }
      }
      char* out = bytes.data() + row * static_cast<std::size_t>(y);
      *out++ = png_filter_left;
      for (std::size_t i = 0; i < plain.size(); ++i) {
        *out++ = static_cast<char>(plain[i] - (i < pixel ? 0 : plain[i - pixel]));
      }
    }
    return {deflate_part(bytes, first + count == format_.height), adler(bytes), bytes.size()};
  }

  void write(int first, const Block& block) override {
    checksum_ = adler_of_both(checksum_, block.checksum, block.unpacked);
    std::string data = first == 0 ? std::string(zlib_header) : std::string();
    data += block.bytes;
    if (first + png_block_rows >= format_.height) put_big(data, checksum_);
    file_.append(png_chunk("IDAT", data));
  }

  void finish() override {
    file_.append(png_chunk("IEND", ""));
    file_.finish();
  }

 private:
  std::uint16_t whole(double x, int c) const {
    double share = (x - format_.low[c]) / (format_.high[c] - format_.low[c]);
    if (format_.is_color) share = linear_to_srgb(static_cast<float>(std::max(0.0, share)));
    return static_cast<std::uint16_t>(std::floor(std::clamp(share, 0.0, 1.0) * 65535 + 0.5));
  }

  RowImageFormat format_;
  NewFile file_;
  std::uint32_t checksum_ = 1;  // Adler-32 of nothing
};

}  // namespace

std::unique_ptr<RowImage> new_png16(const std::filesystem::path& path, const RowImageFormat& format,
                                    const Context& context) {
  return std::make_unique<Png16>(path, format, context);
}

}  // namespace craze
