#include "craze/render/png.h"

#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>

#include "craze/base/error.h"

namespace craze::render {

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// False on any error; libpng reports errors by a long jump, so nothing here has a destructor.
bool encode(std::FILE* file, const Image& image) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_init_io(png, file);
  png_set_IHDR(png, info, image.width, image.height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) {
    png_write_row(png, image.rgb.data() + static_cast<std::size_t>(y) * image.width * 3);
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

}  // namespace

void write_png(const std::string& path, const Image& image) {
  namespace fs = std::filesystem;
  const std::string beside = path + ".part";
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(beside.c_str(), "wb"));
  if (!file) throw Error(ErrorKind::output, "cannot write picture", path, std::strerror(errno));
  const bool encoded = encode(file.get(), image);
  const bool closed = std::fclose(file.release()) == 0;
  std::error_code problem;
  if (encoded && closed) fs::rename(beside, path, problem);
  if (!encoded || !closed || problem) {
    const std::string why = problem ? problem.message() : "the data could not be written";
    fs::remove(beside, problem);
    throw Error(ErrorKind::output, "cannot write picture", path, why);
  }
}

}  // namespace craze::render
