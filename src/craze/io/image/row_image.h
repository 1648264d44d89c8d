// Pictures written some rows at a time, packed by several threads.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "craze/context.h"

namespace craze {

struct RowImageFormat {
  std::int32_t width = 0, height = 0;
  int channels = 1;  ///< 1 grey, 3 red green blue
  /// Integers only: what 0 and 65,535 stand for, per channel. What lies outside is the nearer one.
  std::array<double, 3> low{0, 0, 0}, high{1, 1, 1};
  bool is_color = false;  ///< integers only: they are stored by the curve of sRGB, and say so
};

/// A file of linear numbers that gets its place in finish(), whole. Throws Error(output) where it
/// cannot be written, and Cancelled.
class RowImage {
 public:
  /// Some rows as they stand in the file.
  struct Block {
    std::string bytes;
    std::uint32_t checksum = 0;  ///< of `unpacked` bytes before they were packed
    std::size_t unpacked = 0;
  };

  virtual ~RowImage() = default;
  /// Rows of a block; the last one of a picture has what is left.
  virtual int block_rows() const = 0;
  /// Packs the rows from `first` on: a whole block, width × channels numbers each. Several threads
  /// may pack at a time, in any order; the bytes do not depend on it.
  virtual Block pack(int first, int count, const float* values) const = 0;
  /// Every block once, in order.
  virtual void write(int first, const Block& block) = 0;
  virtual void finish() = 0;
};

/// PNG of 16 bits; ISO/IEC 15948:2004. `context` must outlive it.
std::unique_ptr<RowImage> new_png16(const std::filesystem::path& path, const RowImageFormat& format,
                                    const Context& context);
/// OpenEXR of 32-bit floats in channels Y or R, G, B; scan lines, ZIP.
std::unique_ptr<RowImage> new_exr(const std::filesystem::path& path, const RowImageFormat& format,
                                  const Context& context);

}  // namespace craze
