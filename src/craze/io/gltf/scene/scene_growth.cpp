#include "craze/io/gltf/scene/scene_growth.h"

#include <fmt/format.h>

#include <algorithm>

#include "craze/io/gltf/growth_clip.h"

namespace craze {

namespace {

bool has_targets(const Json& mesh) {
  const Json& primitives = mesh["primitives"];
  return std::any_of(primitives.begin(), primitives.end(), [](const Json& primitive) {
    return primitive.contains("targets") && !primitive["targets"].empty();
  });
}

GltfElements scalars(const std::vector<float>& numbers) {
  GltfElements elements;
  for (const float x : numbers) {
    const double value = x;
    elements.append(&value);
  }
  return elements;
}

}  // namespace

void SceneGrowth::begin(const Showing& showing, const SceneOutput& output) {
  showing_ = showing;
  moves_ = !has_targets(output.root["meshes"][showing.mesh]);
  if (moves_) {
    nodes_.push_back(showing.node);
    return;
  }
  const Json& node = output.root["nodes"][showing.node];
  if (!warn_) return;
  warn_(fmt::format("the cracks of '{}' do not grow, since it has morph targets of its own",
                    node.value("name", fmt::format("node_{}", showing.node))));
}

void SceneGrowth::add_targets(PrimitiveVertices& vertices,
                              const std::vector<std::int32_t>& owner) const {
  if (!moves_) return;
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
  if (!moves_) return;
  Json& mesh = output.root["meshes"][showing_.mesh];
  const std::size_t stages = animation_.stages.size();
  for (Json& primitive : mesh["primitives"]) {
    if (primitive.contains("targets") && !primitive["targets"].empty()) continue;
    const Json& positions = output.accessor(primitive["attributes"]["POSITION"].get<std::size_t>());
    GltfElements still;
    still.components = 3;
    still.count = positions["count"].get<std::size_t>();
    still.bytes.assign(still.count * still.size(), '\0');
    const Json target{{"POSITION", output.add_sparse(still, &positions)}};
    primitive["targets"] = Json(stages, target);
  }
  mesh["weights"] = Json(stages, 0);
  if (mesh.contains("extras") && !mesh["extras"].is_object()) return;  // they may be anything
  for (std::size_t k = 0; k < stages; ++k) {
    mesh["extras"]["targetNames"].push_back("before_" + std::to_string(k + 1));
  }
}

void SceneGrowth::finish(SceneOutput& output) const {
  if (nodes_.empty()) return;
  const GrowthClipKeys clip = growth_clip_keys(animation_);
  const Json bounded{{"min", 0}};
  Json animation{{"name", "growth"}, {"channels", Json::array()}};
  for (const std::size_t node : nodes_) {
    animation["channels"].push_back(
        {{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}});
  }
  animation["samplers"] =
      Json::array({{{"input", output.add(scalars(clip.seconds), SceneOutput::Use::plain, &bounded)},
                    {"interpolation", "LINEAR"},
                    {"output", output.add(scalars(clip.weights), SceneOutput::Use::plain)}}});
  if (!output.root.contains("animations")) output.root["animations"] = Json::array();
  output.root["animations"].push_back(std::move(animation));
}

}  // namespace craze
