// Format: Khronos Group, "glTF 2.0 Specification", 2021, section 3.6.2.
#include "craze/io/gltf/gltf_elements.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "craze/io/bytes/byte_order.h"

namespace craze {

namespace {

template <class Int>
double load_integer(const char* p, bool normalized) {
  const auto value = static_cast<double>(load<Int>(p));
  return normalized ? std::max(-1.0, value / std::numeric_limits<Int>::max()) : value;
}

template <class Int>
void store_integer(char* p, double value, bool normalized) {
  using Limits = std::numeric_limits<Int>;
  if (normalized) value *= Limits::max();
  const double low = Limits::min(), high = Limits::max();
  store(p, static_cast<Int>(std::clamp(std::round(value), low, high)));
}

void store_component(char* p, std::size_t type, double value, bool normalized) {
  switch (type) {
    case 5120:
      return store_integer<std::int8_t>(p, value, normalized);
    case 5121:
      return store_integer<std::uint8_t>(p, value, normalized);
    case 5122:
      return store_integer<std::int16_t>(p, value, normalized);
    case 5123:
      return store_integer<std::uint16_t>(p, value, normalized);
    case 5125:
      return store_integer<std::uint32_t>(p, value, normalized);
    default: {
      constexpr double most = std::numeric_limits<float>::max();
      store(p, static_cast<float>(std::clamp(value, -most, most)));
    }
  }
}

}  // namespace

std::size_t component_size(std::size_t type) {
  switch (type) {
    case 5120:  // BYTE
    case 5121:  // UNSIGNED_BYTE
      return 1;
    case 5122:  // SHORT
    case 5123:  // UNSIGNED_SHORT
      return 2;
    case 5125:  // UNSIGNED_INT
    case float_type:
      return 4;
    default:
      return 0;
  }
}

double load_component(const char* p, std::size_t type, bool normalized) {
  switch (type) {
    case 5120:
      return load_integer<std::int8_t>(p, normalized);
    case 5121:
      return load_integer<std::uint8_t>(p, normalized);
    case 5122:
      return load_integer<std::int16_t>(p, normalized);
    case 5123:
      return load_integer<std::uint16_t>(p, normalized);
    case 5125:
      return load_integer<std::uint32_t>(p, normalized);
    default:
      return load<float>(p);
  }
}

double GltfElements::value(std::size_t element, std::size_t component) const {
  const std::size_t at = element * size() + component * component_size(component_type);
  return load_component(bytes.data() + at, component_type, normalized);
}

void GltfElements::append(const double* values) {
  bytes.resize(bytes.size() + size());
  set(count++, values);
}

void GltfElements::append_copy(std::size_t element) {
  bytes += bytes.substr(element * size(), size());
  ++count;
}

void GltfElements::set(std::size_t element, const double* values) {
  char* at = bytes.data() + element * size();
  for (std::size_t k = 0; k < components; ++k) {
    store_component(at + k * component_size(component_type), component_type, values[k], normalized);
  }
}

bool GltfElements::same(std::size_t a, std::size_t b) const {
  return bytes.compare(a * size(), size(), bytes, b * size(), size()) == 0;
}

GltfElements as_floats(const GltfElements& elements) {
  GltfElements floats;
  floats.components = elements.components;
  floats.bytes.reserve(elements.count * floats.size());
  double values[16];
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t k = 0; k < elements.components; ++k) values[k] = elements.value(i, k);
    floats.append(values);
  }
  return floats;
}

}  // namespace craze
