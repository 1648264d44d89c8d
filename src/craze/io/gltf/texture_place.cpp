#include "craze/io/gltf/texture_place.h"

#include "craze/base/elementary.h"

namespace craze {

using Place = Eigen::Matrix<double, 2, 3>;

Place texture_place(const Json& transform, const GltfJson& json) {
  double offset[2] = {0, 0}, scale[2] = {1, 1};
  json.numbers(transform, "offset", offset, 2);
  json.numbers(transform, "scale", scale, 2);
  const auto angle = transform.find("rotation");
  const double r = angle != transform.end() && angle->is_number() ? angle->get<double>() : 0;
  const double c = elementary::cos(r), s = elementary::sin(r);
  // The file's v runs down: v' = 1 − v before and after.
  Place down;
  down << c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1];
  Place up;
  up << down(0, 0), -down(0, 1), down(0, 1) + down(0, 2),  //
      -down(1, 0), down(1, 1), 1 - down(1, 1) - down(1, 2);
  return up;
}

TextureWraps texture_wraps(const Json& root, const Json& texture) {
  const auto samplers = root.find("samplers");
  const auto number = texture.find("sampler");
  TextureWraps wraps{};
  if (samplers == root.end() || !samplers->is_array() || number == texture.end() ||
      !number->is_number_unsigned() || number->get<std::size_t>() >= samplers->size()) {
    return wraps;
  }
  const Json& sampler = (*samplers)[number->get<std::size_t>()];
  const auto wrap = [&](const char* key) {
    const auto found = sampler.is_object() ? sampler.find(key) : sampler.end();
    if (found == sampler.end() || !found->is_number()) return TextureWrap::repeat;
    const double value = found->get<double>();
    return value == 33071   ? TextureWrap::clamp
           : value == 33648 ? TextureWrap::mirror
                            : TextureWrap::repeat;
  };
  return {wrap("wrapS"), wrap("wrapT")};
}

}  // namespace craze
