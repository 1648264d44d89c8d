// The vertices of a primitive with all their attributes, old and new ones.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "craze/io/gltf/gltf_accessor.h"
#include "craze/io/gltf/scene/blend_elements.h"
#include "craze/io/gltf/scene/cut_scene.h"
#include "craze/io/gltf/scene/part_placement.h"
#include "craze/io/gltf/scene/scene_output.h"

namespace craze {

/// What a primitive needs to know of its surroundings.
struct PrimitivePlace {
  const GltfPart& part;
  const std::vector<Eigen::Matrix4d>& joints;  ///< of the part's skin; empty without
  const std::vector<double>& morph_weights;    ///< with which its targets were read
};

class PrimitiveVertices {
 public:
  /// Reads the attributes that `wanted` (name) says of a primitive of the document, and of its
  /// targets.
  template <class Wanted>
  PrimitiveVertices(const Json& primitive, const PrimitivePlace& place, GltfAccessors& accessors,
                    Wanted&& wanted)
      : primitive_(primitive), place_(place) {
    for (const auto& [name, accessor] : primitive["attributes"].items()) {
      if (wanted(name)) read(name, accessor, accessors);
    }
    if (const auto targets = primitive.find("targets"); targets != primitive.end()) {
      for (const Json& target : *targets) {
        targets_.emplace_back();
        for (const auto& [name, accessor] : target.items()) {
          if (wanted(name)) targets_.back().emplace(name, accessors.elements(accessor));
        }
      }
    }
  }

  /// Some vertices of another's.
  PrimitiveVertices(const PrimitiveVertices& from, const std::vector<std::size_t>& vertices);

  std::size_t count() const { return positions().count; }
  /// Appends vertices where the cut mesh has them, between old ones that have not been moved.
  void append(const CutScene& cut, const std::vector<CutVertices::Vertex>& vertices);
  /// Moves the old vertices to where the cut mesh has them.
  void move(const CutScene& cut, const std::vector<std::int32_t>& owner);
  /// Drops the first n vertices.
  void drop(std::size_t n);
  /// Moves a vertex by a shift in the scene.
  void shift(std::size_t vertex, const Vec3& by);
  /// Sets normals, by vertex, in the scene.
  void set_normals(const std::vector<Vec3>& normals);
  bool has_normals() const { return attributes_.count("NORMAL") > 0; }
  /// Gives a vertex another normal, in the scene, and a tangent square to it; what it has already
  /// is kept to the bit.
  void turn_normal(std::size_t vertex, const Vec3& normal);
  /// Of a vertex, in the axes that the file gives it in.
  Vec3 position(std::size_t vertex) const;
  Vec3 normal(std::size_t vertex) const;
  void set_position(std::size_t vertex, const Vec3& p);
  /// Adds or replaces an attribute.
  void set(const std::string& name, GltfElements elements);
  /// Adds a target that shifts vertices in the scene; those not named stay.
  void add_target(const std::vector<std::pair<std::size_t, Vec3>>& shifts);
  std::size_t target_count() const { return targets_.size(); }
  /// Every target moves positions, if only by nothing.
  void complete_targets();

  /// The accessors, added to the output, as a primitive's "attributes" and "targets".
  Json write_attributes(SceneOutput& output) const;
  Json write_targets(SceneOutput& output) const;

 private:
  using Attributes = std::map<std::string, GltfElements>;

  void read(const std::string& name, const Json& accessor, GltfAccessors& accessors);
  const GltfElements& positions() const { return attributes_.at("POSITION"); }
  /// What the targets have moved a vertex by.
  Vec3 morph(std::size_t vertex) const;
  PartPlacement placement() const;

  const Json& primitive_;
  PrimitivePlace place_;
  Attributes attributes_;       // without joints and weights
  std::vector<JointSet> sets_;  // JOINTS_n, WEIGHTS_n
  std::vector<JointSet> none_;
  std::vector<Attributes> targets_;
};

}  // namespace craze
