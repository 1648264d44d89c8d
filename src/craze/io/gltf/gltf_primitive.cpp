// Format: Khronos Group, "glTF 2.0 Specification", 2021, section 3.7.2.
#include "craze/io/gltf/gltf_primitive.h"

#include <algorithm>

#include "craze/base/text/format.h"
#include "craze/io/bytes/input_error.h"

namespace craze {

std::vector<double> morph_weights(const Json& mesh, const Json* node, const GltfJson& json) {
  const Json& holder = node && node->contains("weights") ? *node : mesh;
  std::vector<double> weights(json.array(holder, "weights").size());
  json.numbers(holder, "weights", weights.data(), weights.size());
  return weights;
}

GltfPrimitive::GltfPrimitive(const Json& primitive, const std::vector<double>& weights,
                             GltfAccessors& accessors, std::function<void(std::size_t)> spend,
                             const std::string& name)
    : weights_(weights), accessors_(accessors), spend_(std::move(spend)), json_(name) {
  const auto attributes = primitive.find("attributes");
  if (attributes == primitive.end() || !attributes->is_object()) {
    json_.fail("a primitive has no attributes");
  }
  attributes_ = &*attributes;
  targets_ = &json_.array(primitive, "targets");
  const auto position = json_.index(*attributes_, "POSITION");
  if (!position) return;
  count_ = accessors_.count(*position);
  // An uncompressed copy may stand beside a compressed one.
  if (json_.extension(primitive, "KHR_draco_mesh_compression") && !accessors_.has_data(*position)) {
    json_.fail("it is compressed with Draco, which is not supported; export it without");
  }
}

std::string GltfPrimitive::key() const {
  return targets_->empty() ? attributes_->dump() : attributes_->dump() + targets_->dump();
}

GltfAccessors::Values GltfPrimitive::read_accessor(const Json& attributes, const char* key) {
  const std::size_t accessor = json_.as_index(attributes[key], key);
  if (accessors_.count(accessor) != count_) {
    json_.fail(fmt::format("the accessor of {} has not the size it should have", printable(key)));
  }
  if (std::string_view(key) == "POSITION") return accessors_.read(accessor);
  return accessors_.read_mended(accessor, mended_number(key));
}

GltfAccessors::Values GltfPrimitive::read(const char* key, std::size_t components,
                                          std::size_t or_components) {
  const auto check = [&](const GltfAccessors::Values& values) {
    if (values.components != components && values.components != or_components) {
      json_.fail(fmt::format("the accessor of {} has not the size it should have", printable(key)));
    }
  };
  GltfAccessors::Values values = read_accessor(*attributes_, key);
  if (std::string_view(key) == "POSITION") spend_(count_);
  check(values);
  for (std::size_t t = 0; t < std::min(weights_.size(), targets_->size()); ++t) {
    const Json& target = (*targets_)[t];
    if (weights_[t] == 0 || !target.is_object() || !target.contains(key)) continue;
    spend_(count_);
    const GltfAccessors::Values shifts = read_accessor(target, key);
    check(shifts);
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t k = 0; k < std::min(values.components, shifts.components); ++k) {
        values.values[values.components * i + k] +=
            weights_[t] * shifts.values[shifts.components * i + k];
      }
    }
  }
  return values;
}

}  // namespace craze
