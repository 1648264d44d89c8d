#include "craze/render/light/environment_file.h"

#include "craze/io/files/read_file.h"
#include "craze/io/image/read_image.h"
#include "craze/render/light/radiance_picture.h"

namespace craze::render {

namespace {

craze::Image to_linear(const craze::Image& image) {
  craze::Image linear{image.width, image.height, 3, {}};
  std::vector<float> values;
  for (std::int32_t y = 0; y < image.height; ++y) {
    for (std::int32_t x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        values.push_back(
            srgb_to_linear(static_cast<float>(image.value(x, y, image.channels < 3 ? 0 : c))));
      }
    }
  }
  linear.values = std::move(values);
  return linear;
}

}  // namespace

std::shared_ptr<const Environment> read_environment(const std::string& path,
                                                    const Context& context) {
  const std::string bytes = read_file(path, "cannot read environment", context);
  craze::Image image = bytes.starts_with("#?") ? read_radiance_picture(bytes, path)
                                               : to_linear(read_image(bytes, path));
  context.check();
  return std::make_shared<const Environment>(std::move(image), path);
}

}  // namespace craze::render
