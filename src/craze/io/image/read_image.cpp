#include "craze/io/image/read_image.h"

#include "craze/io/files/read_file.h"
#include "craze/io/image/image_codecs.h"
#include "craze/io/image/image_size.h"

namespace craze {

Image read_image(std::string_view bytes, const std::string& name) {
  if (is_png(bytes)) return decode_png(bytes, name);
  if (is_jpeg(bytes)) return decode_jpeg(bytes, name);
  fail_image(name, "it is neither a PNG nor a JPEG file");
}

Image read_image_file(const std::filesystem::path& path, const Context& context) {
  return read_image(read_file(path, "cannot read picture", context), path.string());
}

}  // namespace craze
