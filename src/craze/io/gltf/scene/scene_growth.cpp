#include "craze/io/gltf/scene/scene_growth.h"

#include <algorithm>
#include <map>

#include "craze/io/gltf/gltf_primitive.h"
#include "craze/io/gltf/growth_clip.h"
#include "craze/io/gltf/scene/weight_channels.h"

namespace craze {

namespace {

/// The default weights of n targets; those that are not given are 0.
std::vector<float> default_weights(const Json& holder, std::size_t n) {
  std::vector<float> weights(n, 0.0f);
  const auto given = holder.find("weights");
  if (given == holder.end()) return weights;
  for (std::size_t k = 0; k < std::min(n, given->size()); ++k) weights[k] = (*given)[k];
  return weights;
}

GltfElements scalars(const std::vector<float>& numbers) {
  GltfElements elements;
  for (const float x : numbers) {
    const double value = x;
    elements.append(&value);
  }
  return elements;
}

std::size_t channels_with(std::size_t sampler, const Json& animation) {
  const Json& channels = animation["channels"];
  const auto uses = std::count_if(channels.begin(), channels.end(), [&](const Json& channel) {
    return channel["sampler"] == Json(sampler);
  });
  return static_cast<std::size_t>(uses);
}

/// Rows of `from` weights with zeros for as many more as there are `to`.
GltfElements widened(const GltfElements& weights, std::size_t from, std::size_t to) {
  GltfElements wide = weights;
  wide.bytes.clear();
  wide.count = 0;
  for (std::size_t row = 0; row < weights.count / from; ++row) {
    const std::size_t size = from * weights.size();
    wide.bytes += weights.bytes.substr(row * size, size);
    wide.bytes.append((to - from) * weights.size(), '\0');
    wide.count += to;
  }
  return wide;
}

}  // namespace

void SceneGrowth::begin(const Showing& showing, const SceneOutput& output) {
  showing_ = showing;
  own_ = 0;
  const Json& mesh = output.root["meshes"][showing.mesh];
  for (const Json& primitive : mesh["primitives"]) {
    own_ = std::max(own_, target_count(primitive));
  }
  const Json& node = output.root["nodes"][showing.node];
  nodes_.push_back({showing.node, default_weights(node.contains("weights") ? node : mesh, own_)});
}

void SceneGrowth::add_targets(PrimitiveVertices& vertices,
                              const std::vector<std::int32_t>& owner) const {
  while (vertices.target_count() < own_) vertices.add_target({});
  for (const MorphStage& stage : animation_.stages) {
    std::vector<std::pair<std::size_t, Vec3>> shifts;
    for (std::size_t v = 0; v < owner.size(); ++v) {
      const auto found = std::lower_bound(stage.vertices.begin(), stage.vertices.end(), owner[v]);
      if (found == stage.vertices.end() || *found != owner[v]) continue;
      shifts.emplace_back(v,
                          -stage.shifts[static_cast<std::size_t>(found - stage.vertices.begin())]);
    }
    vertices.add_target(shifts);
  }
}

void SceneGrowth::end(SceneOutput& output) {
  Json& mesh = output.root["meshes"][showing_.mesh];
  Json& node = output.root["nodes"][showing_.node];
  const std::size_t all = own_ + animation_.stages.size();
  for (Json& primitive : mesh["primitives"]) {
    const std::size_t has = target_count(primitive);
    if (has >= all) continue;
    const Json& positions = output.accessor(primitive["attributes"]["POSITION"].get<std::size_t>());
    GltfElements still;
    still.components = 3;
    still.count = positions["count"].get<std::size_t>();
    still.bytes.assign(still.count * still.size(), '\0');
    const Json target{{"POSITION", output.add_sparse(still, &positions)}};
    for (std::size_t k = has; k < all; ++k) primitive["targets"].push_back(target);
  }
  for (Json* holder : {&mesh, &node}) {
    if (holder == &node && !node.contains("weights")) continue;
    std::vector<float> weights = default_weights(*holder, own_);
    weights.resize(all, 0.0f);
    (*holder)["weights"] = weights;
  }
  if (mesh.contains("extras") && !mesh["extras"].is_object()) return;  // they may be anything
  Json& names = mesh["extras"]["targetNames"];
  if (own_ > 0 && (!names.is_array() || names.size() != own_)) {
    names = Json::array();
    for (std::size_t k = 0; k < own_; ++k) names.push_back("target_" + std::to_string(k));
  }
  for (std::size_t k = 0; k < animation_.stages.size(); ++k) {
    names.push_back("before_" + std::to_string(k + 1));
  }
}

Json SceneGrowth::add_sampler(const std::vector<float>& own_weights, SceneOutput& output) const {
  const GrowthClipKeys clip = growth_clip_keys(animation_);
  const std::size_t stages = animation_.stages.size();
  std::vector<float> weights;
  for (std::size_t key = 0; key < clip.seconds.size(); ++key) {
    weights.insert(weights.end(), own_weights.begin(), own_weights.end());
    const auto first = clip.weights.begin() + static_cast<std::ptrdiff_t>(key * stages);
    weights.insert(weights.end(), first, first + static_cast<std::ptrdiff_t>(stages));
  }
  const Json bounded{{"min", 0}};
  return {{"input", output.add(scalars(clip.seconds), SceneOutput::Use::plain, &bounded)},
          {"interpolation", "LINEAR"},
          {"output", output.add(scalars(weights), SceneOutput::Use::plain)}};
}

/// Whatever moves the node's own targets says that the cracks are open.
void SceneGrowth::widen_animations(const MovingNode& moving, GltfAccessors& accessors,
                                   SceneOutput& output) const {
  const std::size_t own = moving.own_weights.size();
  if (own == 0 || !output.root.contains("animations")) return;
  for (Json& animation : output.root["animations"]) {
    for (Json& channel : animation["channels"]) {
      const auto moved = moved_weights(channel);
      if (!moved || moved->node != moving.node || !moved->one.empty()) continue;
      const auto number = channel["sampler"].get<std::size_t>();
      Json sampler = animation["samplers"][number];
      const auto old = sampler["output"].get<std::size_t>();
      sampler["output"] =
          output.add(widened(accessors.elements(old), own, own + animation_.stages.size()),
                     SceneOutput::Use::plain, &output.accessor(old));
      if (channels_with(number, animation) == 1) {
        animation["samplers"][number] = std::move(sampler);
      } else {
        channel["sampler"] = animation["samplers"].size();
        animation["samplers"].push_back(std::move(sampler));
      }
    }
  }
}

void SceneGrowth::finish(GltfAccessors& accessors, SceneOutput& output) const {
  if (nodes_.empty()) return;
  Json animation{{"name", "growth"}, {"channels", Json::array()}, {"samplers", Json::array()}};
  std::map<std::vector<float>, std::size_t> samplers;
  for (const MovingNode& moving : nodes_) {
    const auto [found, is_new] =
        samplers.try_emplace(moving.own_weights, animation["samplers"].size());
    if (is_new) animation["samplers"].push_back(add_sampler(moving.own_weights, output));
    animation["channels"].push_back(
        {{"sampler", found->second}, {"target", {{"node", moving.node}, {"path", "weights"}}}});
    widen_animations(moving, accessors, output);
  }
  if (!output.root.contains("animations")) output.root["animations"] = Json::array();
  output.root["animations"].push_back(std::move(animation));
}

}  // namespace craze
