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

}  // namespace craze
