// Vertex attributes of new vertices, from those of the triangle that they lie in.
#pragma once

#include <string>
#include <vector>

#include "craze/io/gltf/gltf_elements.h"
#include "craze/io/gltf/scene/cut_vertices.h"

namespace craze {

/// Appends what an attribute of that name is at each blend. Copies keep their bytes, and so does
/// what is the same at all vertices of a blend. NORMAL and TANGENT become unit again, as far as
/// `unit` says (the shifts of morph targets are none); whole numbers that stand for themselves,
/// such as ids, and the sign of a tangent are the nearest vertex's.
void append_blends(GltfElements& elements, const std::string& name, bool unit,
                   const std::vector<CutVertices::Vertex>& vertices);

/// JOINTS_n and WEIGHTS_n.
struct JointSet {
  GltfElements joints, weights;
};

/// Appends the joints of each blend: the heaviest that there is room for in all sets together,
/// their weights scaled to the sum 1, or to what the sums of its corners are there where a file has
/// others than 1: viewers move new vertices as far as the old ones beside them.
void append_joints(std::vector<JointSet>& sets, const std::vector<CutVertices::Vertex>& vertices);

}  // namespace craze
