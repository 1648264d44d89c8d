#include "craze/io/gltf/gltf_scene.h"

#include <algorithm>

#include "craze/base/text/format.h"

namespace craze {

namespace {

using Mat4 = Eigen::Matrix4d;

std::vector<std::size_t> root_nodes(const Json& root, const GltfNodes& nodes,
                                    const GltfJson& json) {
  std::vector<std::size_t> roots;
  if (!json.array(root, "scenes").empty()) {
    const Json& scene = json.item(root, "scenes", json.index_or(root, "scene", 0));
    for (const Json& node : json.array(scene, "nodes")) {
      roots.push_back(json.as_index(node, "nodes"));
    }
    return roots;
  }
  for (std::size_t i = 0; i < nodes.count(); ++i) {
    if (!nodes.has_parent(i)) roots.push_back(i);
  }
  return roots;
}

/// The instances' own transforms; empty where the node is not instanced.
class GpuInstances {
 public:
  GpuInstances(const Json& node, GltfAccessors& accessors, std::size_t most, const GltfJson& json) {
    const Json* extension = json.extension(node, "EXT_mesh_gpu_instancing");
    if (!extension) return;
    is_instanced_ = true;
    const auto attributes = extension->find("attributes");
    if (attributes == extension->end() || !attributes->is_object()) return;
    const auto read = [&](const char* key, std::size_t components, auto& values) {
      const auto accessor = json.index(*attributes, key);
      if (!accessor) return;
      const std::size_t count = accessors.count(*accessor);
      if (count > most) json.fail("it has more instances than its size allows; join them before");
      values = accessors.read(*accessor);
      const bool differs = has_count_ && count != count_;
      if (values.components != components || differs) {
        json.fail(fmt::format("the accessor of {} has not the size it should have", key));
      }
      count_ = count;
      has_count_ = true;
    };
    read("TRANSLATION", 3, translations_);
    read("ROTATION", 4, rotations_);
    read("SCALE", 3, scales_);
  }

  bool is_instanced() const { return is_instanced_; }
  std::size_t count() const { return count_; }
  Mat4 transform(std::size_t i) const {
    Eigen::Vector3d translation = Eigen::Vector3d::Zero(), scale = Eigen::Vector3d::Ones();
    Eigen::Vector4d rotation(0, 0, 0, 1);
    if (translations_.count > 0) translation = row<3>(translations_, i);
    if (rotations_.count > 0) rotation = row<4>(rotations_, i);
    if (scales_.count > 0) scale = row<3>(scales_, i);
    return compose_transform(translation, rotation, scale);
  }

 private:
  template <int n>
  static Eigen::Matrix<double, n, 1> row(const GltfAccessors::Values& values, std::size_t i) {
    return Eigen::Map<const Eigen::Matrix<double, n, 1>>(&values.values[n * i]);
  }

  bool is_instanced_ = false, has_count_ = false;
  std::size_t count_ = 0;
  GltfAccessors::Values translations_, rotations_, scales_;
};

}  // namespace

std::vector<GltfInstance> scene_instances(const Json& root, GltfNodes& nodes,
                                          GltfAccessors& accessors, std::size_t most,
                                          const std::string& name) {
  const GltfJson json(name);
  std::vector<GltfInstance> instances;
  if (!root.contains("nodes")) {
    for (std::size_t m = 0; m < json.array(root, "meshes").size(); ++m) {
      instances.push_back({m, Mat4::Identity(), {}, nullptr, m, {}});
    }
    return instances;
  }

  const auto add = [&](std::size_t at, const Json& node, const Mat4& world, std::size_t mesh) {
    const auto skin = json.index(node, "skin");
    const GpuInstances copies(node, accessors, most - instances.size(), json);
    if (!copies.is_instanced()) instances.push_back({mesh, world, skin, &node, at, {}});
    for (std::size_t i = 0; i < copies.count(); ++i) {
      const Mat4 placed = world * copies.transform(i);
      if (!placed.allFinite())
        json.fail(fmt::format("the transform of instance {} is not finite", i));
      instances.push_back({mesh, placed, skin, &node, at, i});
    }
    if (instances.size() >= most) {
      json.fail("it has more instances than its size allows; join them before");
    }
  };

  // A stack of its own, so that no depth of nesting exhausts the program's.
  std::vector<std::size_t> stack = root_nodes(root, nodes, json);
  std::reverse(stack.begin(), stack.end());
  std::vector<bool> seen(nodes.count(), false);
  while (!stack.empty()) {
    const std::size_t at = stack.back();
    stack.pop_back();
    const Json& node = json.item(root, "nodes", at);
    if (seen[at]) json.fail(fmt::format("node {} is reached by two ways", at));
    seen[at] = true;
    const Mat4& world = nodes.world(at);
    if (const auto mesh = json.index(node, "mesh")) add(at, node, world, *mesh);
    const Json& children = json.array(node, "children");
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      stack.push_back(json.as_index(*child, "children"));
    }
  }
  return instances;
}

}  // namespace craze
