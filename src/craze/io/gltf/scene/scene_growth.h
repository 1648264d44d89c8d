// Cracks that open one after the other, in a scene that is kept.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/io/gltf/scene/primitive_vertices.h"
#include "craze/io/gltf/scene/scene_output.h"
#include "craze/io/gltf/scene/showings.h"
#include "craze/mesh/morph_animation.h"

namespace craze {

/// Morph targets that take back what each stage of a clip does, and the animation that plays them.
/// They come after those that a part has of its own. Each animation says the weights of all targets
/// of a node: the growth leaves the part's own at their defaults, and the animations that the scene
/// has leave the cracks open.
class SceneGrowth {
 public:
  /// Must outlive this.
  explicit SceneGrowth(const MorphAnimation& animation) : animation_(animation) {}

  /// Says whose vertices come next.
  void begin(const Showing& showing, const SceneOutput& output);
  /// owner: the cut mesh's vertex of each of the vertices; −1: none.
  void add_targets(PrimitiveVertices& vertices, const std::vector<std::int32_t>& owner) const;
  /// Gives the other primitives of the mesh as many targets, which do nothing.
  void end(SceneOutput& output);
  /// Adds the animation. `accessors`: of the document.
  void finish(GltfAccessors& accessors, SceneOutput& output) const;

 private:
  struct MovingNode {
    std::size_t node = 0;
    std::vector<float> own_weights;  ///< of its own targets
  };

  Json add_sampler(const std::vector<float>& own_weights, SceneOutput& output) const;
  void widen_animations(const MovingNode& moving, GltfAccessors& accessors,
                        SceneOutput& output) const;

  const MorphAnimation& animation_;
  Showing showing_;
  std::size_t own_ = 0;  ///< targets of the mesh at hand before
  std::vector<MovingNode> nodes_;
};

}  // namespace craze
