// Channels of animations that move morph weights: by path, or by KHR_animation_pointer.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "craze/io/gltf/gltf_json.h"

namespace craze {

/// What a channel points at, as "/nodes/2/weights"; "" where its target is a node's path.
inline std::string animation_pointer(const Json& channel) {
  const Json::json_pointer at("/target/extensions/KHR_animation_pointer/pointer");
  if (channel["target"].value("path", Json()) != Json("pointer") || !channel.contains(at))
    return "";
  const Json& pointer = channel[at];
  return pointer.is_string() ? pointer.get<std::string>() : "";
}

struct MovedWeights {
  std::size_t node = 0;
  std::string one;  ///< "/3" where the channel moves the weight of one target alone
};

/// Of which node; nothing where the channel moves something else.
inline std::optional<MovedWeights> moved_weights(const Json& channel) {
  const Json& target = channel["target"];
  if (target.value("path", Json()) == Json("weights")) {
    const auto node = target.find("node");
    if (node == target.end() || !node->is_number_integer()) return std::nullopt;
    return MovedWeights{node->get<std::size_t>(), ""};
  }
  constexpr std::string_view nodes = "/nodes/", weights = "/weights";
  const std::string pointer = animation_pointer(channel);
  std::string_view rest = pointer;
  if (!rest.starts_with(nodes)) return std::nullopt;
  rest.remove_prefix(nodes.size());
  MovedWeights moved;
  const auto [end, failed] = std::from_chars(rest.data(), rest.data() + rest.size(), moved.node);
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (failed != std::errc{} || !rest.starts_with(weights)) return std::nullopt;
  moved.one = rest.substr(weights.size());
  if (!moved.one.empty() && moved.one[0] != '/') return std::nullopt;
  return moved;
}

/// Lets a channel that moves weights move those of another node.
inline void move_weights_of(std::size_t node, Json& channel) {
  Json& target = channel["target"];
  if (target["path"] == Json("weights")) {
    target["node"] = node;
    return;
  }
  const std::string one = moved_weights(channel)->one;
  target["extensions"]["KHR_animation_pointer"]["pointer"] =
      "/nodes/" + std::to_string(node) + "/weights" + one;
}

}  // namespace craze
