#include "craze/io/gltf/gltf_nodes.h"

#include <Eigen/Geometry>

#include "craze/base/text/format.h"

namespace craze {

namespace {

using Mat4 = Eigen::Matrix4d;

Mat4 local_transform(const Json& node, const GltfJson& json) {
  Mat4 matrix = Mat4::Identity();
  if (json.numbers(node, "matrix", matrix.data(), 16)) return matrix;  // both column by column
  Eigen::Vector3d translation = Eigen::Vector3d::Zero(), scale = Eigen::Vector3d::Ones();
  Eigen::Vector4d rotation(0, 0, 0, 1);
  json.numbers(node, "translation", translation.data(), 3);
  json.numbers(node, "rotation", rotation.data(), 4);
  json.numbers(node, "scale", scale.data(), 3);
  return compose_transform(translation, rotation, scale);
}

}  // namespace

Mat4 compose_transform(const Eigen::Vector3d& translation, const Eigen::Vector4d& rotation,
                       const Eigen::Vector3d& scale) {
  Mat4 matrix = Mat4::Identity();
  const Eigen::Quaterniond q(rotation[3], rotation[0], rotation[1], rotation[2]);
  matrix.topLeftCorner<3, 3>() = q.normalized().toRotationMatrix() * scale.asDiagonal();
  matrix.topRightCorner<3, 1>() = translation;
  return matrix;
}

GltfNodes::GltfNodes(const Json& root, const std::string& name) : root_(root), json_(name) {
  const std::size_t count = json_.array(root, "nodes").size();
  parents_.assign(count, -1);
  worlds_.resize(count);
  known_.assign(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    for (const Json& child : json_.array(json_.item(root, "nodes", i), "children")) {
      const std::size_t c = json_.as_index(child, "children");
      if (c >= count) json_.item(root, "nodes", c);  // says so
      parents_[c] = static_cast<std::ptrdiff_t>(i);
    }
  }
}

const Mat4& GltfNodes::world(std::size_t node) {
  json_.item(root_, "nodes", node);
  std::vector<std::size_t> way{node};  // up to the first one known, or the root
  while (!known_[way.back()] && parents_[way.back()] >= 0) {
    if (way.size() > count()) json_.fail(fmt::format("node {} is its own ancestor", node));
    way.push_back(static_cast<std::size_t>(parents_[way.back()]));
  }
  for (std::size_t i = way.size(); i-- > 0;) {
    const std::size_t at = way[i];
    if (known_[at]) continue;
    const Mat4 local = local_transform(json_.item(root_, "nodes", at), json_);
    worlds_[at] = parents_[at] < 0 ? local : Mat4(worlds_[parents_[at]] * local);
    if (!worlds_[at].allFinite()) {
      json_.fail(fmt::format("the transform of node {} is not finite", at));
    }
    known_[at] = true;
  }
  return worlds_[node];
}

}  // namespace craze
