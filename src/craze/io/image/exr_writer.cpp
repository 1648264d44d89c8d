// Format: OpenEXR file layout, openexr.com/en/latest/OpenEXRFileLayout.html: one part of scan
// lines, ZIP in blocks of 16.
#include <algorithm>
#include <cstring>
#include <vector>

#include "craze/io/bytes/byte_order.h"
#include "craze/io/files/new_file.h"
#include "craze/io/image/deflate.h"
#include "craze/io/image/row_image.h"

namespace craze {

namespace {

constexpr int exr_block_rows = 16;
constexpr std::uint32_t magic = 20000630, version = 2, float_pixels = 2;
constexpr char zip = 3, increasing_y = 0;

class Exr : public RowImage {
 public:
  Exr(const std::filesystem::path& path, const RowImageFormat& format, const Context& context)
      : format_(format), file_(path, "cannot write map", context) {
    std::string bytes;
    append(bytes, magic);
    append(bytes, version);
    std::string channels;
    // In the order of their names, as their rows are.
    for (const char* name : names()) {
      channels.append(name, std::strlen(name) + 1);
      append(channels, float_pixels);
      append(channels, std::uint32_t{0});
      append(channels, std::uint32_t{1});
      append(channels, std::uint32_t{1});
    }
    channels += '\0';
    add_attribute(bytes, "channels", "chlist", channels);
    add_attribute(bytes, "compression", "compression", std::string(1, zip));
    std::string window;
    for (const std::int32_t x : {0, 0, format.width - 1, format.height - 1}) {
      append(window, static_cast<std::uint32_t>(x));
    }
    add_attribute(bytes, "dataWindow", "box2i", window);
    add_attribute(bytes, "displayWindow", "box2i", window);
    add_attribute(bytes, "lineOrder", "lineOrder", std::string(1, increasing_y));
    std::string one, center;
    append(one, 1.0f);
    append(center, 0.0f);
    append(center, 0.0f);
    add_attribute(bytes, "pixelAspectRatio", "float", one);
    add_attribute(bytes, "screenWindowCenter", "v2f", center);
    add_attribute(bytes, "screenWindowWidth", "float", one);
    bytes += '\0';
    table_ = bytes.size();
    const auto blocks =
        static_cast<std::size_t>((format.height + exr_block_rows - 1) / exr_block_rows);
    bytes.append(8 * blocks, '\0');
    file_.append(bytes);
  }

  int block_rows() const override { return exr_block_rows; }

  Block pack(int, int count, const float* values) const override {
    const auto width = static_cast<std::size_t>(format_.width);
    const auto channels = static_cast<std::size_t>(format_.channels);
    std::string plain;
    plain.reserve(4 * width * channels * static_cast<std::size_t>(count));
    for (int y = 0; y < count; ++y) {
      for (std::size_t c = channels; c-- > 0;) {  // B, G, R
        for (std::size_t x = 0; x < width; ++x) {
          append(plain, values[(static_cast<std::size_t>(y) * width + x) * channels + c]);
        }
      }
    }
    // Even bytes first, then odd ones; then differences.
    std::string apart(plain.size(), '\0');
    const std::size_t half = (plain.size() + 1) / 2;
    for (std::size_t i = 0; i < plain.size(); ++i) apart[(i % 2 ? half : 0) + i / 2] = plain[i];
    for (std::size_t i = apart.size(); i-- > 1;) {
      apart[i] = static_cast<char>(apart[i] - apart[i - 1] + 128);
    }
    std::string packed = zlib_pack(apart);
    return {packed.size() < plain.size() ? std::move(packed) : std::move(plain), 0, 0};
  }

  void write(int first, const Block& block) override {
    append(offsets_, file_.size());
    std::string head;
    append(head, static_cast<std::uint32_t>(first));
    append(head, static_cast<std::uint32_t>(block.bytes.size()));
    file_.append(head + block.bytes);
  }

  void finish() override {
    file_.overwrite(table_, offsets_);
    file_.finish();
  }

 private:
  std::vector<const char*> names() const {
    return format_.channels == 3 ? std::vector<const char*>{"B", "G", "R"}
                                 : std::vector<const char*>{"Y"};
  }

  static void add_attribute(std::string& bytes, const char* name, const char* type,
                            const std::string& value) {
    bytes.append(name, std::strlen(name) + 1);
    bytes.append(type, std::strlen(type) + 1);
    append(bytes, static_cast<std::uint32_t>(value.size()));
    bytes += value;
  }

  RowImageFormat format_;
  NewFile file_;
  std::uint64_t table_ = 0;
  std::string offsets_;
};

}  // namespace

std::unique_ptr<RowImage> new_exr(const std::filesystem::path& path, const RowImageFormat& format,
                                  const Context& context) {
  return std::make_unique<Exr>(path, format, context);
}

}  // namespace craze
