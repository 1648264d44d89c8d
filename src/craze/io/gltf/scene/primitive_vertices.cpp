#include "craze/io/gltf/scene/primitive_vertices.h"

#include <algorithm>

#include "craze/io/polygons/single_precision.h"

namespace craze {

namespace {

Vec3 vector(const GltfElements& elements, std::size_t i) {
  return {elements.value(i, 0), elements.value(i, 1), elements.value(i, 2)};
}

/// Throws Error(request) for a coordinate beyond single precision.
void check_range(const Vec3& p) {
  static_cast<void>(to_floats(p, "GLB"));
}

/// n zero vectors.
GltfElements zero_vectors(std::size_t n) {
  GltfElements zeros;
  zeros.components = 3;
  zeros.count = n;
  zeros.bytes.assign(n * zeros.size(), '\0');
  return zeros;
}

}  // namespace

void PrimitiveVertices::read(const std::string& name, const Json& accessor,
                             GltfAccessors& accessors) {
  GltfElements elements = accessors.elements(accessor);
  if (name.starts_with("WEIGHTS_")) return;  // with its joints
  if (name.starts_with("JOINTS_")) {
    const std::string weights = "WEIGHTS_" + name.substr(7);
    const Json& all = primitive_["attributes"];
    if (all.contains(weights)) {
      sets_.push_back({std::move(elements), accessors.elements(all[weights])});
    }
    return;
  }
  // What a coarse grid holds of the old positions is kept; it has no room for new ones.
  if (name == "POSITION" && elements.component_type != float_type) elements = as_floats(elements);
  attributes_.emplace(name, std::move(elements));
}

PrimitiveVertices::PrimitiveVertices(const PrimitiveVertices& from,
                                     const std::vector<std::size_t>& vertices)
    : primitive_(from.primitive_), place_(from.place_) {
  const auto picked = [&](const GltfElements& elements) {
    GltfElements some = elements;
    some.bytes.clear();
    for (const std::size_t v : vertices) {
      some.bytes.append(elements.bytes, v * elements.size(), elements.size());
    }
    some.count = vertices.size();
    return some;
  };
  for (const auto& [name, elements] : from.attributes_) attributes_.emplace(name, picked(elements));
  for (const JointSet& set : from.sets_) sets_.push_back({picked(set.joints), picked(set.weights)});
  for (const Attributes& target : from.targets_) {
    targets_.emplace_back();
    for (const auto& [name, elements] : target) targets_.back().emplace(name, picked(elements));
  }
}

PartPlacement PrimitiveVertices::placement() const {
  return {place_.part, place_.joints, place_.joints.empty() ? none_ : sets_};
}

Vec3 PrimitiveVertices::position(std::size_t vertex) const {
  return vector(positions(), vertex);
}

Vec3 PrimitiveVertices::normal(std::size_t vertex) const {
  return vector(attributes_.at("NORMAL"), vertex);
}

Vec3 PrimitiveVertices::morph(std::size_t vertex) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t t = 0; t < std::min(targets_.size(), place_.morph_weights.size()); ++t) {
    const auto shifts = targets_[t].find("POSITION");
    if (place_.morph_weights[t] == 0 || shifts == targets_[t].end()) continue;
    sum += place_.morph_weights[t] * vector(shifts->second, vertex);
  }
  return sum;
}

void PrimitiveVertices::append(const CutScene& cut,
                               const std::vector<CutVertices::Vertex>& vertices) {
  const std::size_t first = count();
  for (auto& [name, elements] : attributes_) append_blends(elements, name, true, vertices);
  if (!sets_.empty()) append_joints(sets_, vertices);
  for (Attributes& target : targets_) {
    for (auto& [name, elements] : target) append_blends(elements, name, false, vertices);
  }
  const PartPlacement placed = placement();
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const auto& [blend, of] = vertices[k];
    // Between joints a point is where the triangle is, not where its own joints would take it.
    if (placed.is_skinned() && !blend.is_copy()) {
      const Vec3 p = placed.to_local(first + k, cut.mesh().positions[of]) - morph(first + k);
      check_range(p);
      attributes_.at("POSITION").set(first + k, p.data());
    } else {
      shift(first + k, cut.shift(place_.part, blend, of));
    }
  }
}

void PrimitiveVertices::move(const CutScene& cut, const std::vector<std::int32_t>& owner) {
  for (std::size_t v = 0; v < owner.size(); ++v) {
    if (owner[v] < 0) continue;
    shift(v, cut.shift(place_.part, CutScene::itself(static_cast<std::uint32_t>(v)), owner[v]));
  }
}

void PrimitiveVertices::shift(std::size_t vertex, const Vec3& by) {
  if (by.isZero(0)) return;
  const Vec3 p = position(vertex) + placement().shift_to_local(vertex, by);
  check_range(p);
  attributes_.at("POSITION").set(vertex, p.data());
}

void PrimitiveVertices::drop(std::size_t n) {
  const auto drop_of = [n](GltfElements& elements) {
    elements.bytes.erase(0, n * elements.size());
    elements.count -= n;
  };
  for (auto& [name, elements] : attributes_) drop_of(elements);
  for (JointSet& set : sets_) {
    drop_of(set.joints);
    drop_of(set.weights);
  }
  for (Attributes& target : targets_) {
    for (auto& [name, elements] : target) drop_of(elements);
  }
}

void PrimitiveVertices::set_normals(const std::vector<Vec3>& normals) {
  GltfElements elements;
  elements.components = 3;
  const PartPlacement placed = placement();
  for (std::size_t v = 0; v < normals.size(); ++v) {
    Vec3 n = placed.normal_to_local(v, normals[v]);
    if (n.isZero(0)) n = Vec3::UnitZ();  // of a face without area; it must be unit
    elements.append(n.data());
  }
  set("NORMAL", std::move(elements));
}

void PrimitiveVertices::turn_normal(std::size_t vertex, const Vec3& normal) {
  constexpr double unnoticed = 1e-6;
  GltfElements& normals = attributes_.at("NORMAL");
  const Vec3 n = placement().normal_to_local(vertex, normal);
  if ((n - vector(normals, vertex).normalized()).norm() < unnoticed) return;
  normals.set(vertex, n.data());
  const auto tangents = attributes_.find("TANGENT");
  if (tangents == attributes_.end() || tangents->second.components != 4) return;
  const Vec3 old = vector(tangents->second, vertex), along = old - old.dot(n) * n;
  if (along.isZero(0)) return;
  const Eigen::Vector4d turned =
      (Eigen::Vector4d() << along.normalized(), tangents->second.value(vertex, 3)).finished();
  tangents->second.set(vertex, turned.data());
}

void PrimitiveVertices::set_position(std::size_t vertex, const Vec3& p) {
  check_range(p);
  attributes_.at("POSITION").set(vertex, p.data());
}

void PrimitiveVertices::set(const std::string& name, GltfElements elements) {
  attributes_[name] = std::move(elements);
}

void PrimitiveVertices::add_target(const std::vector<std::pair<std::size_t, Vec3>>& shifts) {
  GltfElements moved = zero_vectors(count());
  const PartPlacement placed = placement();
  for (const auto& [vertex, by] : shifts) {
    const Vec3 local = placed.shift_to_local(vertex, by);
    check_range(local);
    moved.set(vertex, local.data());
  }
  targets_.emplace_back();
  targets_.back().emplace("POSITION", std::move(moved));
}

void PrimitiveVertices::complete_targets() {
  for (Attributes& target : targets_) target.try_emplace("POSITION", zero_vectors(count()));
}

Json PrimitiveVertices::write_attributes(SceneOutput& output) const {
  using Use = SceneOutput::Use;
  const Json& old = primitive_["attributes"];
  const auto like = [&](const std::string& name) -> const Json* {
    if (const auto found = old.find(name); found != old.end()) {
      return &output.accessor(found->get<std::size_t>());
    }
    return nullptr;
  };
  Json json = Json::object();
  for (const auto& [name, elements] : attributes_) {
    json[name] = output.add(elements, Use::vertices, like(name));
  }
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    const std::string number = std::to_string(s);
    json["JOINTS_" + number] = output.add(sets_[s].joints, Use::vertices, like("JOINTS_" + number));
    json["WEIGHTS_" + number] =
        output.add(sets_[s].weights, Use::vertices, like("WEIGHTS_" + number));
  }
  return json;
}

Json PrimitiveVertices::write_targets(SceneOutput& output) const {
  const auto old = primitive_.find("targets");
  Json json = Json::array();
  for (std::size_t t = 0; t < targets_.size(); ++t) {
    const bool is_old = old != primitive_.end() && t < old->size();
    Json target = Json::object();
    for (const auto& [name, elements] : targets_[t]) {
      const Json* like = is_old && (*old)[t].contains(name)
                             ? &output.accessor((*old)[t][name].get<std::size_t>())
                             : nullptr;
      const bool is_sparse = !like || like->contains("sparse");
      // Positions must have bounds, those of targets too.
      const Json bounded{{"min", 0}};
      if (!like && name == "POSITION") like = &bounded;
      target[name] = is_sparse ? output.add_sparse(elements, like)
                               : output.add(elements, SceneOutput::Use::vertices, like);
    }
    json.push_back(std::move(target));
  }
  return json;
}

}  // namespace craze
