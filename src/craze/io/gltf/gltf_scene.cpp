#include "craze/io/gltf/gltf_scene.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "craze/base/tensor.h"

namespace craze {

namespace {

using Mat4 = Eigen::Matrix4d;

std::vector<std::size_t> root_nodes(const Json& root, const GltfJson& json) {
  std::vector<std::size_t> nodes;
  if (!json.array(root, "scenes").empty()) {
    const Json& scene = json.item(root, "scenes", json.index_or(root, "scene", 0));
    for (const Json& node : json.array(scene, "nodes")) {
      nodes.push_back(json.as_index(node, "nodes"));
    }
    return nodes;
  }
  const std::size_t count = json.array(root, "nodes").size();
  std::vector<bool> is_child(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    for (const Json& child : json.array(json.item(root, "nodes", i), "children")) {
      const std::size_t c = json.as_index(child, "children");
      if (c < count) is_child[c] = true;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_child[i]) nodes.push_back(i);
  }
  return nodes;
}

Mat4 local_transform(const Json& node, const GltfJson& json) {
  Mat4 matrix = Mat4::Identity();
  if (json.numbers(node, "matrix", matrix.data(), 16)) return matrix;  // both column by column
  Vec3 translation = Vec3::Zero(), scale = Vec3::Ones();
  Eigen::Vector4d rotation(0, 0, 0, 1);
  json.numbers(node, "translation", translation.data(), 3);
  json.numbers(node, "rotation", rotation.data(), 4);
  json.numbers(node, "scale", scale.data(), 3);
  const Eigen::Quaterniond q(rotation.w(), rotation.x(), rotation.y(), rotation.z());
  matrix.topLeftCorner<3, 3>() = q.normalized().toRotationMatrix() * scale.asDiagonal();
  matrix.topRightCorner<3, 1>() = translation;
  return matrix;
}

}  // namespace

std::vector<GltfInstance> scene_instances(const Json& root, const std::string& name) {
  const GltfJson json(name);
  std::vector<GltfInstance> instances;
  if (!root.contains("nodes")) {
    for (std::size_t m = 0; m < json.array(root, "meshes").size(); ++m) {
      instances.push_back({m, Mat4::Identity()});
    }
    return instances;
  }

  // A stack of its own, so that no depth of nesting exhausts the program's.
  struct Visit {
    std::size_t node;
    Mat4 parent;
  };
  std::vector<Visit> stack;
  for (const std::size_t node : root_nodes(root, json)) stack.push_back({node, Mat4::Identity()});
  std::reverse(stack.begin(), stack.end());
  std::vector<bool> seen(json.array(root, "nodes").size(), false);
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const Json& node = json.item(root, "nodes", visit.node);
    if (seen[visit.node]) json.fail(fmt::format("node {} is reached by two ways", visit.node));
    seen[visit.node] = true;
    const Mat4 world = visit.parent * local_transform(node, json);
    if (!world.allFinite()) {
      json.fail(fmt::format("the transform of node {} is not finite", visit.node));
    }
    if (const auto mesh = json.index(node, "mesh")) instances.push_back({*mesh, world});
    const Json& children = json.array(node, "children");
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      stack.push_back({json.as_index(*child, "children"), world});
    }
  }
  return instances;
}

}  // namespace craze
