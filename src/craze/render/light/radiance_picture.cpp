// Format: Ward, "Real pixels", Graphics Gems II, 1991; Radiance's file formats, "RGBE".
#include "craze/render/light/radiance_picture.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <vector>

#include "craze/base/text/format.h"
#include "craze/error.h"

namespace craze::render {

namespace {

/// Pixels of a picture, at most; and of one that is packed more tightly than any of light is,
/// besides two for each of its bytes.
constexpr std::int64_t most_pixels = std::int64_t{1} << 27, free_pixels = std::int64_t{1} << 23;

using Rgbe = std::array<std::uint8_t, 4>;

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  craze::Image read() {
    craze::Image image;
    image.channels = 3;
    read_header(image);
    std::vector<float> values;
    values.reserve(static_cast<std::size_t>(3) * image.width * image.height);
    std::vector<Rgbe> row(static_cast<std::size_t>(image.width));
    for (std::int32_t y = 0; y < image.height; ++y) {
      read_row(row);
      for (const Rgbe& p : row) {
        // A mantissa of 8 bits below the binary point.
        const double unit = p[3] == 0 ? 0 : std::ldexp(1.0, p[3] - 136);
        for (std::size_t c = 0; c < 3; ++c) values.push_back(static_cast<float>(p[c] * unit));
      }
    }
    image.values = std::move(values);
    return image;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw Error(ErrorKind::input, "cannot read environment", name_, why);
  }

  std::string_view line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos) fail("its header has no end");
    std::string_view text = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }

  void read_header(craze::Image& image) {
    for (std::string_view text = line(); !text.empty(); text = line()) {
      if (text.starts_with("FORMAT=") && text != "FORMAT=32-bit_rle_rgbe") {
        fail(fmt::format("its format is {}, not 32-bit_rle_rgbe", text.substr(7)));
      }
    }
    const std::string_view size = line();
    const std::size_t second = size.find(" +X ");
    if (!size.starts_with("-Y ") || second == std::string_view::npos) {
      fail("its size is not given as -Y HEIGHT +X WIDTH");
    }
    image.height = number(size.substr(3, second - 3));
    image.width = number(size.substr(second + 4));
    const std::int64_t pixels = static_cast<std::int64_t>(image.width) * image.height;
    if (pixels > most_pixels) fail("it has too many pixels");
    if (pixels > free_pixels + 2 * static_cast<std::int64_t>(bytes_.size())) {
      fail("it has too many pixels for so short a file");
    }
    // However it is packed, a row has at least four bytes.
    if (static_cast<std::int64_t>(bytes_.size() - at_) < 4 * std::int64_t{image.height}) cut_off();
  }

  std::int32_t number(std::string_view text) const {
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < 1) {
      fail("its size is not given as -Y HEIGHT +X WIDTH");
    }
    return value;
  }

  [[noreturn]] void cut_off() const { fail("it is cut off"); }

  std::uint8_t byte() {
    if (at_ >= bytes_.size()) cut_off();
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }

  Rgbe pixel() { return {byte(), byte(), byte(), byte()}; }

  void read_row(std::vector<Rgbe>& row) {
    const Rgbe first = pixel();
    const std::size_t size = row.size();
    const bool by_channel = first[0] == 2 && first[1] == 2 && first[2] < 128;
    if (!by_channel || size < 8 || size > 32767) return read_pixels(first, row);
    if (static_cast<std::size_t>(first[2] << 8 | first[3]) != size) {
      fail("a row has another length than the picture");
    }
    for (std::size_t channel = 0; channel < 4; ++channel) read_channel(channel, row);
  }

  void read_channel(std::size_t channel, std::vector<Rgbe>& row) {
    for (std::size_t x = 0; x < row.size();) {
      const std::uint8_t code = byte();
      const bool is_run = code > 128;
      const std::size_t count = is_run ? code - 128u : code;
      if (count == 0 || count > row.size() - x) fail("a run is longer than its row");
      std::uint8_t value = is_run ? byte() : std::uint8_t{0};
      for (std::size_t k = 0; k < count; ++k) {
        if (!is_run) value = byte();
        row[x++][channel] = value;
      }
    }
  }

  /// One after the other; 1, 1, 1, n repeats the pixel before n times, and more of them in
  /// succession 256 n, 65,536 n … times.
  void read_pixels(Rgbe p, std::vector<Rgbe>& row) {
    int shift = 0;
    for (std::size_t x = 0; x < row.size();) {
      if (p[0] == 1 && p[1] == 1 && p[2] == 1) {
        if (x == 0 || shift > 24) fail("a run repeats nothing");
        const std::uint64_t count = static_cast<std::uint64_t>(p[3]) << shift;
        if (count > row.size() - x) fail("a run is longer than its row");
        const Rgbe last = row[x - 1];
        for (std::uint64_t k = 0; k < count; ++k) row[x++] = last;
        shift += 8;
      } else {
        row[x++] = p;
        shift = 0;
      }
      if (x < row.size()) p = pixel();
    }
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

}  // namespace

craze::Image read_radiance_picture(std::string_view bytes, const std::string& name) {
  return Reader(bytes, name).read();
}

}  // namespace craze::render
