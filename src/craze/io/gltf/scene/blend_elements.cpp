#include "craze/io/gltf/scene/blend_elements.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "craze/tensor.h"

namespace craze {

namespace {

constexpr std::size_t most_components = 16;
/// How far weights of 8 bits may add up beside 1.
constexpr double rounded_sum = 0.01;

bool is_same_everywhere(const GltfElements& elements, const VertexBlend& blend) {
  for (int i = 1; i < blend.size(); ++i) {
    if (!elements.same(blend.from[0], blend.from[i])) return false;
  }
  return true;
}

void make_unit(double* values) {
  const double length = Eigen::Map<const Vec3>(values).norm();
  if (!(length > 0)) return;
  for (int k = 0; k < 3; ++k) values[k] /= length;
}

/// Appends a vertex with these pairs of joint and weight, heaviest first.
void append_vertex(std::vector<JointSet>& sets,
                   const std::vector<std::pair<double, double>>& joints) {
  for (std::size_t s = 0; s < sets.size(); ++s) {
    double numbers[4] = {}, weights[4] = {};
    for (std::size_t k = 0; k < 4 && 4 * s + k < joints.size(); ++k) {
      numbers[k] = joints[4 * s + k].first;
      weights[k] = joints[4 * s + k].second;
    }
    GltfElements& stored = sets[s].weights;
    stored.append(weights);
    // A weight that the type rounds to nothing leaves no joint.
    for (std::size_t k = 0; k < 4; ++k) {
      if (stored.value(stored.count - 1, k) == 0) numbers[k] = 0;
    }
    sets[s].joints.append(numbers);
  }
}

/// What the stored weights of the last vertex lack to their sum is given to the heaviest.
void correct_sum(std::vector<JointSet>& sets, double wanted) {
  const std::size_t vertex = sets[0].weights.count - 1;
  double sum = 0;
  for (const JointSet& set : sets) {
    for (std::size_t k = 0; k < 4; ++k) sum += set.weights.value(vertex, k);
  }
  double weights[4];
  for (std::size_t k = 0; k < 4; ++k) weights[k] = sets[0].weights.value(vertex, k);
  weights[0] += wanted - sum;
  sets[0].weights.set(vertex, weights);
}

}  // namespace

void append_blends(GltfElements& elements, const std::string& name, bool unit,
                   const std::vector<CutVertices::Vertex>& vertices) {
  const bool is_tangent = name == "TANGENT";
  const bool is_number =
      name.starts_with('_') && elements.component_type != float_type && !elements.normalized;
  double values[most_components];
  for (const CutVertices::Vertex& vertex : vertices) {
    const VertexBlend& blend = vertex.blend;
    if (is_same_everywhere(elements, blend)) {
      elements.append_copy(blend.from[0]);
      continue;
    }
    const std::uint32_t nearest = blend.nearest();
    if (is_number) {
      elements.append_copy(nearest);
      continue;
    }
    for (std::size_t k = 0; k < elements.components; ++k) {
      values[k] = 0;
      for (int i = 0; i < blend.size(); ++i) {
        values[k] += blend.weights[i] * elements.value(blend.from[i], k);
      }
    }
    if (unit && (is_tangent || name == "NORMAL")) make_unit(values);
    if (is_tangent && elements.components == 4) values[3] = elements.value(nearest, 3);
    elements.append(values);
  }
}

void append_joints(std::vector<JointSet>& sets, const std::vector<CutVertices::Vertex>& vertices) {
  for (const CutVertices::Vertex& vertex : vertices) {
    const VertexBlend& blend = vertex.blend;
    if (blend.is_copy()) {
      for (JointSet& set : sets) {
        set.joints.append_copy(blend.from[0]);
        set.weights.append_copy(blend.from[0]);
      }
      continue;
    }
    std::map<double, double> weight_of;  // by joint
    for (int i = 0; i < blend.size(); ++i) {
      for (const JointSet& set : sets) {
        for (std::size_t k = 0; k < 4; ++k) {
          const double weight = set.weights.value(blend.from[i], k);
          if (weight > 0) {
            weight_of[set.joints.value(blend.from[i], k)] += blend.weights[i] * weight;
          }
        }
      }
    }
    std::vector<std::pair<double, double>> joints(weight_of.begin(), weight_of.end());
    double wanted = 0;
    for (const auto& joint : joints) wanted += joint.second;
    if (std::abs(wanted - 1) <= rounded_sum) wanted = 1;
    std::stable_sort(joints.begin(), joints.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    joints.resize(std::min(joints.size(), 4 * sets.size()));
    double sum = 0;
    for (const auto& joint : joints) sum += joint.second;
    for (auto& joint : joints) joint.second = joint.second / sum * wanted;
    append_vertex(sets, joints);
    if (!joints.empty()) correct_sum(sets, wanted);
  }
}

}  // namespace craze
