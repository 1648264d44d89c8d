#include "craze/io/gltf/gltf_accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "craze/io/bytes/base64.h"
#include "craze/io/bytes/byte_order.h"
#include "craze/io/bytes/input_error.h"

namespace craze {

namespace {

std::size_t component_size(std::size_t type) {
  switch (type) {
    case 5120:  // BYTE
    case 5121:  // UNSIGNED_BYTE
      return 1;
    case 5122:  // SHORT
    case 5123:  // UNSIGNED_SHORT
      return 2;
    case 5125:  // UNSIGNED_INT
    case 5126:  // FLOAT
      return 4;
    default:
      return 0;
  }
}

std::size_t component_count(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4") return 4;
  return 0;
}

template <class Int>
double load_integer(const char* p, bool normalized) {
  const auto value = static_cast<double>(load<Int>(p));
  return normalized ? std::max(-1.0, value / std::numeric_limits<Int>::max()) : value;
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

}  // namespace

std::string_view GltfAccessors::source(const std::string& uri) {
  auto found = sources_.find(uri);
  if (found != sources_.end()) return found->second;
  std::string content;
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(";base64,");
    auto decoded = comma == std::string::npos
                       ? std::nullopt
                       : decode_base64(std::string_view(uri).substr(comma + 8));
    if (!decoded) json_.fail("a data URI is not base64");
    content = std::move(*decoded);
  } else if (loader_) {
    content = loader_(uri);
    loaded_bytes_ += content.size();
  } else {
    json_.fail(fmt::format("buffer file '{}' cannot be opened from here", printable(uri)));
  }
  return sources_.emplace(uri, std::move(content)).first->second;
}

std::string_view GltfAccessors::buffer(std::size_t index) {
  if (const auto known = buffers_.find(index); known != buffers_.end()) return known->second;
  const Json& buffer = json_.item(root_, "buffers", index);
  std::string_view bytes = bin_;
  if (const std::string uri = json_.text(buffer, "uri"); !uri.empty()) {
    bytes = source(uri);
  } else if (index != 0 || bin_.empty()) {
    json_.fail(fmt::format("buffer {} has no data", index));
  }
  const std::size_t size = json_.index_or(buffer, "byteLength", 0);
  if (size > bytes.size()) {
    json_.fail(fmt::format("buffer {} should have {} bytes but has {}", index, size, bytes.size()));
  }
  return buffers_.emplace(index, bytes.substr(0, size)).first->second;
}

std::string_view GltfAccessors::view(std::size_t buffer_view) {
  const Json& view = json_.item(root_, "bufferViews", buffer_view);
  const auto index = json_.index(view, "buffer");
  if (!index) json_.fail("a bufferView has no buffer");
  const std::string_view bytes = buffer(*index);
  const std::size_t offset = json_.index_or(view, "byteOffset", 0);
  const std::size_t size = json_.index_or(view, "byteLength", 0);
  if (offset > bytes.size() || size > bytes.size() - offset) {
    json_.fail(fmt::format("bufferView {} reaches beyond its buffer", buffer_view));
  }
  return bytes.substr(offset, size);
}

std::size_t GltfAccessors::count(std::size_t accessor) const {
  return json_.index_or(json_.item(root_, "accessors", accessor), "count", 0);
}

GltfAccessors::Layout GltfAccessors::layout(std::size_t accessor) {
  const Json& json = json_.item(root_, "accessors", accessor);
  const std::string name = fmt::format("accessor {}", accessor);
  if (json.contains("sparse"))
    json_.fail(fmt::format("{} is sparse, which is not supported", name));
  const auto view_index = json_.index(json, "bufferView");
  if (!view_index) json_.fail(fmt::format("{} has no bufferView", name));
  Layout layout;
  layout.count = count(accessor);
  layout.components = component_count(json_.text(json, "type"));
  if (layout.components == 0)
    json_.fail(fmt::format("{} is not of type SCALAR, VEC2, VEC3 or VEC4", name));
  layout.component_type = json_.index_or(json, "componentType", 0);
  const std::size_t size = component_size(layout.component_type) * layout.components;
  if (size == 0) json_.fail(fmt::format("{} has an unknown componentType", name));
  const auto normalized = json.find("normalized");
  layout.normalized = normalized != json.end() && *normalized == Json(true);

  const std::string_view bytes = view(*view_index);
  layout.stride = json_.index_or(root_["bufferViews"][*view_index], "byteStride", size);
  if (layout.stride < size)
    json_.fail(fmt::format("{} has a byteStride smaller than its elements", name));
  const std::size_t offset = json_.index_or(json, "byteOffset", 0);
  const bool fits =
      layout.count == 0 || (offset <= bytes.size() && size <= bytes.size() - offset &&
                            layout.count - 1 <= (bytes.size() - offset - size) / layout.stride);
  if (!fits) json_.fail(fmt::format("{} reaches beyond its bufferView", name));
  if (layout.count > 0) layout.first = bytes.data() + offset;
  return layout;
}

GltfAccessors::Values GltfAccessors::read(std::size_t accessor) {
  const Layout in = layout(accessor);
  Values out{in.count, in.components, {}};
  out.values.reserve(in.count * in.components);
  const std::size_t size = component_size(in.component_type);
  for (std::size_t i = 0; i < in.count; ++i) {
    for (std::size_t k = 0; k < in.components; ++k) {
      const char* p = in.first + i * in.stride + k * size;
      out.values.push_back(load_component(p, in.component_type, in.normalized));
      if (!std::isfinite(out.values.back())) {
        json_.fail(fmt::format("accessor {} element {} is not a finite number", accessor, i));
      }
    }
  }
  return out;
}

std::vector<std::uint32_t> GltfAccessors::read_indices(std::size_t accessor) {
  const Layout in = layout(accessor);
  const bool is_unsigned =
      in.component_type == 5121 || in.component_type == 5123 || in.component_type == 5125;
  if (in.components != 1 || !is_unsigned) {
    json_.fail(fmt::format("accessor {} does not hold indices", accessor));
  }
  std::vector<std::uint32_t> indices;
  indices.reserve(in.count);
  for (std::size_t i = 0; i < in.count; ++i) {
    const double value = load_component(in.first + i * in.stride, in.component_type, false);
    indices.push_back(static_cast<std::uint32_t>(value));
  }
  return indices;
}

}  // namespace craze
