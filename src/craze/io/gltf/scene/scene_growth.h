// Cracks that open one after the other, in a scene that is kept.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "craze/io/gltf/scene/primitive_vertices.h"
#include "craze/io/gltf/scene/scene_output.h"
#include "craze/io/gltf/scene/showings.h"
#include "craze/mesh/morph_animation.h"

namespace craze {

/// Morph targets that take back what each stage of a clip does, and the animation that plays them.
/// A part that has morph targets of its own stays open all the time, and its name is told.
class SceneGrowth {
 public:
  /// Both must outlive this.
  SceneGrowth(const MorphAnimation& animation, const std::function<void(const std::string&)>& warn)
      : animation_(animation), warn_(warn) {}

  /// Says whose vertices come next.
  void begin(const Showing& showing, const SceneOutput& output);
  /// owner: the cut mesh's vertex of each of the vertices; −1: none.
  void add_targets(PrimitiveVertices& vertices, const std::vector<std::int32_t>& owner) const;
  /// Gives the other primitives of the mesh as many targets, which do nothing.
  void end(SceneOutput& output);
  /// Adds the animation.
  void finish(SceneOutput& output) const;

 private:
  const MorphAnimation& animation_;
  const std::function<void(const std::string&)>& warn_;
  Showing showing_;
  bool moves_ = false;
  std::vector<std::size_t> nodes_;  ///< that move
};

}  // namespace craze
