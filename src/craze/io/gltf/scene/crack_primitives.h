// What cracks add to a scene: side walls, lines, and numbers of vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/io/gltf/gltf_accessor.h"
#include "craze/io/gltf/scene/cut_scene.h"
#include "craze/io/gltf/scene/primitive_vertices.h"
#include "craze/io/gltf/scene/scene_output.h"
#include "craze/io/gltf/scene/showings.h"

namespace craze {

class SceneGrowth;

/// What the primitives that are added are made with.
struct PrimitiveSource {
  const CutScene& cut;
  const Json& primitive;  ///< beside it
  const PrimitivePlace& place;
  GltfAccessors& accessors;
};

/// Side walls as a primitive: placed, textured and moved as the rim above them, with corners of
/// their own. `growth` may be null.
Json wall_primitive(const PrimitiveSource& source, const std::vector<std::int32_t>& walls,
                    std::size_t material, const SceneGrowth* growth, SceneOutput& output);

/// How lines are drawn on the whole scene.
struct LineStyle {
  std::vector<Vec3> lifts;  ///< #V of the cut mesh (line_lifts.h)
  std::size_t material = 0;
};

/// Halfedges 3f+i of the cut mesh as a primitive that moves with the part: of lines, or of bands of
/// triangles where joints move it, by which few viewers move lines.
Json line_primitive(const PrimitiveSource& source, const std::vector<std::int32_t>& crack_edges,
                    const LineStyle& style, SceneOutput& output);

/// A mesh of these primitives, and a node that shows it below the part's own; at the top of the
/// scene where joints place it.
void add_line_node(const Showing& showing, Json primitives, SceneOutput& output);

/// Takes out of a primitive how its triangles were given: mode, compression.
void forget_form(Json& primitive);

/// The cut mesh's vertex attributes that the run added or the document's surface had not, as
/// `_NAME`; −1 for vertices without owner. owner: the cut mesh's vertex of each.
void add_crack_attributes(const CutScene& cut, const std::vector<std::int32_t>& owner,
                          PrimitiveVertices& vertices);

}  // namespace craze
