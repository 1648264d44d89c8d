// The layer as it cracks: its mesh and the state on it, edited together.
#pragma once

#include <cstdint>

#include "craze/mesh/triangle_mesh.h"
#include "craze/model/stress_field.h"

namespace craze {

/// A TriangleMesh and its StressField. Each edit changes both, so that #V and #F of the field are
/// always the mesh's and the forces those of the stress around every node; there is no other way to
/// edit the mesh.
class CrackedSheet {
 public:
  /// Throws Error(request) where the field is not one of this mesh.
  CrackedSheet(TriangleMesh mesh, StressField field);

  const TriangleMesh& mesh() const { return mesh_; }
  const StressField& field() const { return field_; }
  /// For what changes stress or displacement on the mesh as it is.
  StressField& field() { return field_; }

  /// TriangleMesh::split_edge. The halves keep the parent's σ; the new node lies between the ends
  /// and takes its u from them. On the border it is held where the end of its open edge is.
  TriangleMesh::Split split(std::int32_t h, double t);
  /// TriangleMesh::cut. A copy inherits u, and is held where its original is.
  TriangleMesh::Cut cut(std::int32_t h, std::int32_t crack);
  /// TriangleMesh::slide. The vertex takes u from between the two ends; the faces of its star keep
  /// their unstrained stress and get what the displacements now make of it.
  void slide(std::int32_t h, double t);
  /// TriangleMesh::renumber, of the field too.
  void renumber(const Numbering& numbering);
  /// Gives back the memory that was kept for more edits.
  void shrink_to_fit();

 private:
  TriangleMesh mesh_;
  StressField field_;
};

}  // namespace craze
