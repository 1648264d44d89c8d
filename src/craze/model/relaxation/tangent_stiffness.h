// The stiffness of the layer for displacements in its tangent planes, row by row.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/simd.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/model/stress_field.h"
#include "craze/tensor.h"
#include "craze/threads.h"

namespace craze {

/// The columns a and b of a 3x2 orthonormal basis of the plane square to a unit normal; a function
/// of the normal alone (Duff et al. 2017, "Building an orthonormal basis, revisited").
struct PlaneBasis {
  explicit PlaneBasis(const Vec3& normal);
  Vec3 a, b;
};

/// K + κ M, K = Σ A BᵀB, with two unknowns a node: the components of its displacement in the
/// PlaneBasis of its normal. The operator of the equilibrium (equilibrium.h), kept assembled, since
/// a crack changes a few rows and many solves read the rest. Single precision: it only has to say
/// which correction to make; what is left afterwards is computed from the forces themselves.
/// About 240 bytes a node.
class TangentStiffness {
 public:
  /// One row of 2x2 blocks, row-major (k00 k01 k10 k11). The first entry is the diagonal.
  struct Row {
    const std::int32_t* columns;  ///< node of each block
    const Vec4f* blocks;
    std::int32_t count;
  };

  /// Faces of which a node has the lowest index of the three: each face is in one such list.
  /// So many can be read, whatever the count.
  static constexpr std::int32_t readable_faces = 8;
  struct Faces {
    const std::int32_t* first;
    std::int32_t count;
  };

  /// adhesion: κ, 1/length².
  explicit TangentStiffness(double adhesion) : adhesion_(adhesion) {}

  bool empty() const { return rows_.empty(); }
  void assemble(const TriangleMesh& mesh, const StressField& field, const Threads& threads = 1);
  /// Assembles the rows of all corners of the faces around these nodes again. Nodes that are new
  /// must be among them.
  void update(const TriangleMesh& mesh, const StressField& field,
              const std::vector<std::int32_t>& nodes, const Threads& threads);

  Row row(std::int32_t v) const {
    const Extent& extent = rows_[v];
    return {columns_.data() + extent.begin, blocks_.data() + extent.begin, extent.count};
  }
  /// Asks for a row, or for where it is, some time before it is read.
  void prefetch(std::int32_t v) const {
    const std::uint32_t begin = rows_[v].begin;
    const char* blocks = reinterpret_cast<const char*>(blocks_.data() + begin);
    for (int line = 0; line < 2; ++line) __builtin_prefetch(blocks + 64 * line);
    __builtin_prefetch(columns_.data() + begin);
  }
  void prefetch_faces(std::int32_t v) const { __builtin_prefetch(&faces_[rows_[v].begin]); }
  void prefetch_extent(std::int32_t v) const { __builtin_prefetch(&rows_[v]); }
  Faces own_faces(std::int32_t v) const { return {faces_.data() + rows_[v].begin, rows_[v].faces}; }

 private:
  struct Extent {
    std::uint32_t begin = 0;
    std::int32_t count = 0, capacity = 0, faces = 0;
  };

  /// A row as it is put together.
  struct Draft {
    std::vector<std::int32_t> columns;
    std::vector<std::array<double, 4>> blocks;
  };

  void draft_row(const TriangleMesh& mesh, const StressField& field, std::int32_t v,
                 Draft& draft) const;
  void make_room(const TriangleMesh& mesh, std::int32_t v, std::int32_t spare);
  void store_row(const TriangleMesh& mesh, std::int32_t v, const Draft& draft);

  double adhesion_;
  std::vector<Extent> rows_;  // #V
  std::vector<std::int32_t> columns_, faces_;
  std::vector<Vec4f> blocks_;
  std::vector<std::int32_t> touched_;  // of update
};

}  // namespace craze
