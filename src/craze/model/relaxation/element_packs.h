// The elements' geometry once more, in single precision and eight at a time, for steps that are
// put right in double precision afterwards.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/simd.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/stress_field.h"

namespace craze {

/// Eight elements, 48 bytes each: √(A/2) ∇λ of corners 1 and 2, the unit normal, and the corners.
/// (By e and N of Element the forces on a thin element are small differences of large numbers.)
/// Lanes beyond the last face are zero and answer nothing.
struct ElementPack {
  static constexpr std::int32_t size = 8;

  Vec8f g1[3], g2[3], normal[3];
  std::int32_t corners[3][size] = {};
};

/// All elements of a mesh in packs of consecutive faces, kept up as the mesh is cut.
class ElementPacks {
 public:
  /// Takes in faces appended since, and those around the nodes listed, whose star changed.
  void update(const TriangleMesh& mesh, const StressField& field,
              const std::vector<std::int32_t>& changed_nodes);

  const ElementPack* data() const { return packs_.data(); }

 private:
  void set(const TriangleMesh& mesh, const StressField& field, std::int32_t f);

  std::int32_t faces_ = 0;
  std::vector<ElementPack> packs_;
};

/// Adds to `force_change` (#V) how the forces of packs [begin, end) change when the nodes move by
/// `moves` (#V): −K Δp, as element_response. Lanes 3 of both are 0.
void add_force_changes(const ElementPack* packs, const Vec4f* moves, Vec4f* force_change,
                       std::int32_t begin, std::int32_t end);

}  // namespace craze
