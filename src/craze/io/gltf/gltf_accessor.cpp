#include "craze/io/gltf/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "craze/base/text/format.h"
#include "craze/io/bytes/data_uri.h"
#include "craze/io/bytes/input_error.h"

namespace craze {

namespace {

bool is_unsigned(std::size_t type) {
  return type == 5121 || type == 5123 || type == 5125;
}

std::size_t component_count(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4" || type == "MAT2") return 4;
  if (type == "MAT3") return 9;
  if (type == "MAT4") return 16;
  return 0;
}

/// Columns begin at multiples of four bytes.
bool has_padded_columns(const std::string& type, std::size_t component_size) {
  const std::size_t rows = type == "MAT2" ? 2 : type == "MAT3" ? 3 : 4;
  return type.starts_with("MAT") && rows * component_size % 4 != 0;
}

}  // namespace

std::string_view GltfAccessors::source(const std::string& uri) {
  auto found = sources_.find(uri);
  if (found != sources_.end()) return found->second;
  std::string content;
  if (is_data_uri(uri)) {
    auto decoded = decode_data_uri(uri);
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
  for (const char* meshopt : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    const Json& held = json_.item(root_, "buffers", *index);
    // What it stands in for may be there as well; then the compressed copy is of no concern.
    if (json_.extension(view, meshopt) && json_.extension(held, meshopt) &&
        json_.text(held, "uri").empty()) {
      json_.fail("it is compressed with meshopt, which is not supported; export it without");
    }
  }
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

bool GltfAccessors::has_data(std::size_t accessor) const {
  const Json& json = json_.item(root_, "accessors", accessor);
  return json.contains("bufferView") || json.contains("sparse");
}

void GltfAccessors::place(Layout& layout, std::size_t buffer_view, std::size_t offset,
                          std::size_t stride, const std::string& what) {
  const std::string_view bytes = view(buffer_view);
  const std::size_t size = component_size(layout.component_type) * layout.components;
  layout.stride = stride == 0 ? size : stride;
  if (layout.stride < size) {
    json_.fail(fmt::format("{} has a byteStride smaller than its elements", what));
  }
  const bool fits =
      layout.count == 0 || (offset <= bytes.size() && size <= bytes.size() - offset &&
                            layout.count - 1 <= (bytes.size() - offset - size) / layout.stride);
  if (!fits) json_.fail(fmt::format("{} reaches beyond its bufferView", what));
  if (layout.count > 0) layout.first = bytes.data() + offset;
}

GltfAccessors::Layout GltfAccessors::layout(std::size_t accessor) {
  const Json& json = json_.item(root_, "accessors", accessor);
  const std::string name = fmt::format("accessor {}", accessor);
  Layout layout;
  layout.count = count(accessor);
  const std::string type = json_.text(json, "type");
  layout.components = component_count(type);
  if (layout.components == 0) {
    json_.fail(fmt::format("{} is not of type SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4", name));
  }
  layout.component_type = json_.index_or(json, "componentType", 0);
  if (component_size(layout.component_type) == 0) {
    json_.fail(fmt::format("{} has an unknown componentType", name));
  }
  if (has_padded_columns(type, component_size(layout.component_type))) {
    json_.fail(
        fmt::format("{} is a {} of so small numbers that its columns have gaps between "
                    "them, which is not supported",
                    name, type));
  }
  const auto normalized = json.find("normalized");
  layout.normalized = normalized != json.end() && *normalized == Json(true);
  if (const auto view_index = json_.index(json, "bufferView")) {
    const Json& view = json_.item(root_, "bufferViews", *view_index);
    place(layout, *view_index, json_.index_or(json, "byteOffset", 0),
          json_.index_or(view, "byteStride", 0), name);
  } else if (layout.count > most_ / layout.components) {
    json_.fail(
        fmt::format("{} stands for {} zeros, too many for the file's size", name, layout.count));
  }
  return layout;
}

void GltfAccessors::substitute(const Json& sparse, const Layout& base, std::size_t accessor,
                               char* out) {
  const std::string name = fmt::format("the sparse part of accessor {}", accessor);
  const auto part = [&](const char* key) -> const Json& {
    const auto found = sparse.is_object() ? sparse.find(key) : sparse.end();
    if (found == sparse.end() || !found->is_object())
      json_.fail(fmt::format("{} has no {}", name, key));
    return *found;
  };
  const auto place_part = [&](Layout& of, const Json& json) {
    const auto view_index = json_.index(json, "bufferView");
    if (!view_index) json_.fail(fmt::format("{} has no bufferView", name));
    place(of, *view_index, json_.index_or(json, "byteOffset", 0), 0, name);
  };
  Layout indices;
  indices.count = json_.index_or(sparse, "count", 0);
  indices.components = 1;
  indices.component_type = json_.index_or(part("indices"), "componentType", 0);
  if (!is_unsigned(indices.component_type)) {
    json_.fail(fmt::format("{} has indices that are not unsigned", name));
  }
  Layout values = base;
  values.count = indices.count;
  place_part(indices, part("indices"));
  place_part(values, part("values"));
  const std::size_t size = component_size(base.component_type) * base.components;
  for (std::size_t i = 0; i < indices.count; ++i) {
    const double index =
        load_component(indices.first + i * indices.stride, indices.component_type, false);
    if (index >= static_cast<double>(base.count)) {
      json_.fail(fmt::format("{} asks for element {} of {}", name, index, base.count));
    }
    std::memcpy(out + static_cast<std::size_t>(index) * size, values.first + i * values.stride,
                size);
  }
}

GltfElements GltfAccessors::elements(std::size_t accessor) {
  const Layout in = layout(accessor);
  GltfElements out;
  out.count = in.count;
  out.components = in.components;
  out.component_type = in.component_type;
  out.normalized = in.normalized;
  const std::size_t size = out.size();
  out.bytes.resize(in.count * size);
  for (std::size_t i = 0; in.first && i < in.count; ++i) {
    std::memcpy(out.bytes.data() + i * size, in.first + i * in.stride, size);
  }
  const Json& json = root_["accessors"][accessor];
  if (const auto sparse = json.find("sparse"); sparse != json.end()) {
    substitute(*sparse, in, accessor, out.bytes.data());
  }
  return out;
}

GltfAccessors::Values GltfAccessors::read(std::size_t accessor) {
  Values out = read_any(accessor);
  for (std::size_t i = 0; i < out.values.size(); ++i) {
    if (std::isfinite(out.values[i])) continue;
    json_.fail(
        fmt::format("accessor {} element {} is not a finite number", accessor, i / out.components));
  }
  return out;
}

GltfAccessors::Values GltfAccessors::read_mended(std::size_t accessor, double instead) {
  Values out = read_any(accessor);
  for (double& number : out.values) {
    if (std::isfinite(number)) continue;
    number = instead;
    broken_[accessor] = instead;
  }
  return out;
}

GltfAccessors::Values GltfAccessors::read_any(std::size_t accessor) {
  const GltfElements in = elements(accessor);
  Values out{in.count, in.components, {}};
  out.values.reserve(in.count * in.components);
  const std::size_t step = component_size(in.component_type);
  for (std::size_t i = 0; i < in.count * in.components; ++i) {
    out.values.push_back(
        load_component(in.bytes.data() + i * step, in.component_type, in.normalized));
  }
  return out;
}

std::vector<std::uint32_t> GltfAccessors::read_indices(std::size_t accessor) {
  const Layout in = layout(accessor);
  if (in.components != 1 || !is_unsigned(in.component_type)) {
    json_.fail(fmt::format("accessor {} does not hold indices", accessor));
  }
  std::vector<std::uint32_t> indices;
  indices.reserve(in.count);
  for (const double value : read(accessor).values) {
    indices.push_back(static_cast<std::uint32_t>(value));
  }
  return indices;
}

}  // namespace craze
