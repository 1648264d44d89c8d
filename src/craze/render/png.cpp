#include "craze/render/png.h"

#include <png.h>

#include <csetjmp>
#include <new>
#include <string>

#include "craze/error.h"
#include "craze/io/files/atomic_file.h"

namespace craze::render {

namespace {

/// Called by libpng with what it has compressed.
void append(png_structp png, png_bytep bytes, std::size_t size) {
  try {
    static_cast<std::string*>(png_get_io_ptr(png))
        ->append(reinterpret_cast<const char*>(bytes), size);
  } catch (const std::bad_alloc&) {
    png_error(png, "out of memory");
  }
}

void flush(png_structp) {}

constexpr int rows_between_looks = 16;

/// False on any error and where the context cancels; libpng reports errors by a long jump, so
/// nothing here has a destructor.
bool encode(std::string& file, const Image& image, const Context& context) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_set_write_fn(png, &file, append, flush);
  png_set_IHDR(png, info, image.width, image.height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) {
    if (y % rows_between_looks == 0) {
      if (context.is_cancelled()) {
        png_destroy_write_struct(&png, &info);
        return false;
      }
      context.report({"write", static_cast<double>(y) / image.height});
    }
    png_write_row(png, image.rgb.data() + static_cast<std::size_t>(y) * image.width * 3);
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  context.report({"write", 1});
  return true;
}

}  // namespace

void write_png(const std::string& path, const Image& image, const Context& context) {
  constexpr const char* what = "cannot write picture";
  std::string file;
  if (!encode(file, image, context)) {
    context.check();
    throw Error(ErrorKind::output, what, path, "it cannot be compressed");
  }
  write_file(path, file, what, context);
}

}  // namespace craze::render
