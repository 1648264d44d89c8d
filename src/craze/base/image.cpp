#include "craze/base/image.h"

#include <limits>
#include <type_traits>

namespace craze {

namespace {

/// What the largest integer stands for is 1; floats are as they are.
template <class T>
double to_unit(T value) {
  if constexpr (std::is_integral_v<T>) {
    return static_cast<double>(value) / std::numeric_limits<T>::max();
  } else {
    return value;
  }
}

}  // namespace

double Image::value(std::int32_t x, std::int32_t y, int c) const {
  const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  const std::size_t i = (row + static_cast<std::size_t>(x)) * static_cast<std::size_t>(channels) +
                        static_cast<std::size_t>(c);
  return std::visit([i](const auto& numbers) { return to_unit(numbers[i]); }, values);
}

GreyImage to_grey(const Image& image) {
  GreyImage grey{image.width, image.height, {}};
  const auto channels = static_cast<std::size_t>(image.channels);
  std::visit(
      [&](const auto& numbers) {
        grey.pixels.reserve(numbers.size() / channels);
        for (std::size_t i = 0; i < numbers.size(); i += channels) {
          const auto value = [&](std::size_t c) { return to_unit(numbers[i + c]); };
          const double mix =
              channels < 3 ? value(0) : 0.2126 * value(0) + 0.7152 * value(1) + 0.0722 * value(2);
          grey.pixels.push_back(static_cast<float>(mix));
        }
      },
      image.values);
  return grey;
}

}  // namespace craze
