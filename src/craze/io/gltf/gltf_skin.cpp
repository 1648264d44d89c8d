// Format: Khronos Group, "glTF 2.0 Specification", 2021, section 3.7.3.
#include "craze/io/gltf/gltf_skin.h"

#include "craze/base/text/format.h"

namespace craze {

std::vector<Eigen::Matrix4d> joint_matrices(const Json& root, std::size_t skin, GltfNodes& nodes,
                                            GltfAccessors& accessors, const std::string& name) {
  const GltfJson json(name);
  const Json& object = json.item(root, "skins", skin);
  std::vector<Eigen::Matrix4d> matrices;
  for (const Json& joint : json.array(object, "joints")) {
    matrices.push_back(nodes.world(json.as_index(joint, "joints")));
  }
  if (matrices.empty()) json.fail(fmt::format("skin {} has no joints", skin));
  if (const auto inverse = json.index(object, "inverseBindMatrices")) {
    if (accessors.count(*inverse) < matrices.size()) {
      json.fail(fmt::format("skin {} has fewer inverse bind matrices than joints", skin));
    }
    const GltfAccessors::Values bind = accessors.read(*inverse);
    if (bind.components != 16) {
      json.fail(fmt::format("the inverse bind matrices of skin {} are not of type MAT4", skin));
    }
    for (std::size_t j = 0; j < matrices.size(); ++j) {
      matrices[j] = matrices[j] * Eigen::Map<const Eigen::Matrix4d>(&bind.values[16 * j]);
    }
  }
  return matrices;
}

GltfSkinning::GltfSkinning(const Json& attributes, std::size_t vertices,
                           const std::vector<Eigen::Matrix4d>& joints, GltfAccessors& accessors,
                           const std::string& name)
    : joints_(joints) {
  const GltfJson json(name);
  for (std::size_t n = 0;; ++n) {
    const auto joint = json.index(attributes, fmt::format("JOINTS_{}", n).c_str());
    const auto weight = json.index(attributes, fmt::format("WEIGHTS_{}", n).c_str());
    if (!joint || !weight) break;
    Set& set = sets_.emplace_back(Set{accessors.read(*joint), accessors.read(*weight)});
    for (const auto* values : {&set.joints, &set.weights}) {
      if (values->count != vertices || values->components != 4) {
        json.fail(fmt::format("JOINTS_{0} and WEIGHTS_{0} have not the size they should have", n));
      }
    }
    for (std::size_t i = 0; i < set.joints.values.size(); ++i) {
      const double j = set.joints.values[i];
      const bool known = j >= 0 && j < static_cast<double>(joints.size());
      if (!known && set.weights.values[i] != 0) {
        json.fail(fmt::format("JOINTS_{} asks for joint {} of {}", n, j, joints.size()));
      }
      if (!known) set.joints.values[i] = 0;
    }
  }
}

Eigen::Matrix4d GltfSkinning::matrix(std::size_t vertex) const {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  double total = 0;
  for (const Set& set : sets_) {
    for (std::size_t k = 4 * vertex; k < 4 * vertex + 4; ++k) {
      const double weight = set.weights.values[k];
      if (weight == 0) continue;
      sum += weight * joints_[static_cast<std::size_t>(set.joints.values[k])];
      total += weight;
    }
  }
  if (!(total > 0)) return joints_[static_cast<std::size_t>(sets_[0].joints.values[4 * vertex])];
  return sum / total;
}

}  // namespace craze
