// Format: Khronos Group, "glTF 2.0 Specification", 2021, section 3.6.
#include "craze/io/gltf/glb_buffer.h"

#include <algorithm>
#include <limits>

#include "craze/io/bytes/byte_order.h"
#include "craze/io/gltf/glb_file.h"
#include "craze/io/gltf/gltf_elements.h"

namespace craze {

namespace {

using nlohmann::ordered_json;

constexpr int uint_component = 5125;
constexpr int array_buffer = 34962, element_array_buffer = 34963;
constexpr const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};

using Bounds = std::array<std::array<float, 3>, 2>;

Bounds bounds(std::span<const std::array<float, 3>> points, Bounds box) {
  for (const auto& p : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      box[0][k] = std::min(box[0][k], p[k]);
      box[1][k] = std::max(box[1][k], p[k]);
    }
  }
  return box;
}

std::span<const float> flat(std::span<const std::array<float, 3>> vectors) {
  return {vectors.empty() ? nullptr : vectors.front().data(), 3 * vectors.size()};
}

}  // namespace

template <class T>
std::size_t GlbBuffer::add_view(std::span<const T> numbers, Target target) {
  views_.push_back(
      {{"buffer", 0}, {"byteOffset", size_}, {"byteLength", sizeof(T) * numbers.size()}});
  if (target != Target::none) {
    views_.back()["target"] = target == Target::vertices ? array_buffer : element_array_buffer;
  }
  std::string& bytes = bytes_.emplace_back(sizeof(T) * numbers.size(), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) store(&bytes[sizeof(T) * i], numbers[i]);
  size_ += bytes.size();
  return views_.size() - 1;
}

std::size_t GlbBuffer::add_accessor(std::size_t view, int component, std::size_t count,
                                    const char* type) {
  accessors_.push_back(
      {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
  return accessors_.size() - 1;
}

std::size_t GlbBuffer::add_floats(std::span<const float> numbers, int components, Target target) {
  return add_accessor(add_view(numbers, target), float_type,
                      numbers.size() / static_cast<std::size_t>(components), types[components - 1]);
}

std::size_t GlbBuffer::add_indices(std::span<const std::uint32_t> indices) {
  return add_accessor(add_view(indices, Target::triangles), uint_component, indices.size(),
                      types[0]);
}

std::size_t GlbBuffer::add_positions(std::span<const std::array<float, 3>> positions) {
  const std::size_t accessor = add_floats(flat(positions), 3, Target::vertices);
  Bounds box;
  box[0].fill(std::numeric_limits<float>::max());
  box[1].fill(std::numeric_limits<float>::lowest());
  box = bounds(positions, box);
  accessors_[accessor]["min"] = box[0];
  accessors_[accessor]["max"] = box[1];
  return accessor;
}

std::size_t GlbBuffer::add_sparse_vectors(std::size_t count, std::span<const std::uint32_t> indices,
                                          std::span<const std::array<float, 3>> vectors) {
  const Bounds box = bounds(vectors, {});  // with the zeros
  accessors_.push_back({{"componentType", float_type},
                        {"count", count},
                        {"type", types[2]},
                        {"min", box[0]},
                        {"max", box[1]}});
  if (!indices.empty()) {
    accessors_.back()["sparse"] = {
        {"count", indices.size()},
        {"indices",
         {{"bufferView", add_view(indices, Target::none)}, {"componentType", uint_component}}},
        {"values", {{"bufferView", add_view(flat(vectors), Target::none)}}}};
  }
  return accessors_.size() - 1;
}

std::size_t GlbBuffer::add_bytes(const std::string& bytes) {
  const std::size_t view = add_view(std::span<const char>(bytes), Target::none);
  const std::size_t aligned = (size_ + 3) / 4 * 4;  // whatever comes next is
  bytes_.back().append(aligned - size_, '\0');
  size_ = aligned;
  return view;
}

std::size_t GlbBuffer::add_keys(std::span<const float> keys) {
  const std::size_t accessor = add_floats(keys, 1, Target::none);
  const auto [low, high] = std::minmax_element(keys.begin(), keys.end());
  accessors_[accessor]["min"] = {*low};
  accessors_[accessor]["max"] = {*high};
  return accessor;
}

void GlbBuffer::write(ordered_json root, ByteSink& sink) const {
  root["accessors"] = accessors_;
  root["bufferViews"] = views_;
  root["buffers"] = {{{"byteLength", size_}}};
  write_glb_file(root.dump(-1, ' ', false, ordered_json::error_handler_t::replace), bytes_, sink);
}

}  // namespace craze
