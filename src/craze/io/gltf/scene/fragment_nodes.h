// Fragments as nodes of a scene that is kept.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "craze/collider.h"
#include "craze/io/gltf/scene/loose_primitive.h"

namespace craze {

/// What a showing consists of before it is taken apart.
struct LoosePart {
  LoosePrimitive whole;
  std::vector<double> fragment;         ///< by triangle of it
  std::optional<std::size_t> material;  ///< of walls
};

/// Shows each fragment by a node NAME_VALUE below the showing's own, with the same mesh but for its
/// triangles, its origin at the fragment's centroid; where joints place all of it, at the top of
/// the scene, with the same skin. What moved the weights of the showing's targets moves theirs. The
/// showing's own node keeps its primitives other than `taken`. Of `solids` the origin is the centre
/// of mass (MeshFileOptions::solids). `growth` may be null.
void add_fragment_nodes(const Showing& showing, const std::vector<LoosePart>& parts,
                        const std::vector<std::size_t>& taken, const std::string& name,
                        bool is_skinned, std::optional<Collider> solids, SceneGrowth* growth,
                        SceneOutput& output);

}  // namespace craze
