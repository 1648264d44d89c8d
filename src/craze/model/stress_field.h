// The stress of every triangle, and the forces and virtual displacements of every node.
#pragma once

#include <cstdint>
#include <vector>

#include "craze/base/simd.h"
#include "craze/mesh/triangle_mesh.h"
#include "craze/tensor.h"
#include "craze/threads.h"

namespace craze {

/// One triangle's geometry and stress, 96 bytes, laid out for the relaxation.
///
/// Stress is kept as T, the components of A σ in the basis of the element's two edge vectors
/// e₁ = p₁ − p₀ and e₂ = p₂ − p₀:  A σ = Σ T_ab e_a e_bᵀ  (A: area). Then Eq. 1 is just
/// f_a = −Σ_b T_ab e_b, and Eq. 7 is T += N q N with q_ab = ½ (e_a·Δe_b + e_b·Δe_a) and
/// N = √A (β βᵀ): no tangent frame enters, so none has to be stored or inherited.
/// Where β is capped, e₁ and e₂ are the dual basis of the capped β instead of the true edges.
struct Element {
  Vec4d e1;  ///< e₁ and N₁₁
  Vec4d e2;  ///< e₂ and N₁₂
  Vec4d t;   ///< T₁₁, T₂₂, T₁₂ and N₂₂

  Vec3 edge1() const { return {e1[0], e1[1], e1[2]}; }
  Vec3 edge2() const { return {e2[0], e2[1], e2[2]}; }
};

/// The stress state of a TriangleMesh, kept in step with its cuts.
class StressField {
 public:
  /// All zero. `cap` is the limit on β's singular values, 1/length (basis_matrix.h).
  StressField(const TriangleMesh& mesh, double cap, const Threads& threads = 1);

  const std::vector<Element>& elements() const { return elements_; }
  std::vector<Element>& elements() { return elements_; }

  /// σ of a face in world axes: force per length, tension positive, normal components zero.
  Sym3 stress(const TriangleMesh& mesh, std::int32_t f) const;
  /// Adds a world tensor's part in the plane of the face to its σ. Forces are left as they were:
  /// call update_forces or update_force afterwards.
  void add_stress(const TriangleMesh& mesh, std::int32_t f, const Sym3& sigma);

  /// F of a node: the sum of the forces that its elements exert on it.
  Vec3 force(std::int32_t v) const { return {forces_[v][0], forces_[v][1], forces_[v][2]}; }
  /// u of a node: the sum of its virtual displacements. The node itself never moves.
  Vec3 displacement(std::int32_t v) const {
    return {displacements_[v][0], displacements_[v][1], displacements_[v][2]};
  }
  std::vector<Vec4d>& forces() { return forces_; }
  std::vector<Vec4d>& displacements() { return displacements_; }
  const std::vector<Vec4d>& forces() const { return forces_; }
  const std::vector<Vec4d>& displacements() const { return displacements_; }
  /// #V, A_n in the adhesion κ A_n u_n: a third of the area of the faces around each node, each
  /// times the factor of its source face given to set_adhesion.
  const std::vector<double>& node_areas() const { return node_areas_; }
  /// #V, unit normals of the surface at the nodes: area-weighted means of the faces' where the mesh
  /// was when the field was made, and between those of the ends of a split edge.
  const std::vector<Vec3>& normals() const { return normals_; }
  /// Whether a node is held: nothing that pulls at it moves it.
  bool is_held(std::int32_t v) const { return !held_.empty() && held_[v] != 0; }
  void hold(std::int32_t v);
  /// Factors on κ per source face, ≥ 0; copied.
  void set_adhesion(const TriangleMesh& mesh, std::vector<double> factors);

  /// [IO06 Eq. 1] summed over the star of v / over all nodes.
  void update_force(const TriangleMesh& mesh, std::int32_t v);
  void update_forces(const TriangleMesh& mesh, const Threads& threads = 1);

  /// [IO06 Eqs. 6, 7] Adds to σ of these faces, in this order, what virtual displacements of their
  /// corners make of it, and the change of Eq. 1's forces to the corners. `slot` (#V) says where in
  /// `shifts` (length) a node's displacement is, −1: it stays. A bound of the sizes of those
  /// changes is added to `drift` (#V): no eigenvalue of ς changes by more than its node's sum.
  void displace(const TriangleMesh& mesh, const std::vector<std::int32_t>& faces,
                const std::vector<std::int32_t>& slot, const std::vector<Vec4d>& shifts,
                std::vector<double>& drift);

  double singular_value_cap() const { return cap_; }

 private:
  friend class CrackedSheet;

  /// Follows TriangleMesh::split_edge: the halves keep the parent's σ, the new node lies between
  /// the ends of the split edge and takes its u from them. Forces around are updated.
  void follow(const TriangleMesh& mesh, const TriangleMesh::Split& split, std::int32_t from,
              std::int32_t to, double t);
  /// Follows TriangleMesh::cut for one end: the copy (or −1) inherits u; both get their own F.
  void follow(const TriangleMesh& mesh, std::int32_t vertex, std::int32_t copy);

  /// Per face of v's star, in the order of for_each_outgoing: σ less what the displacements of its
  /// corners made of it (Eqs. 6, 7), world axes.
  std::vector<Sym3> unstrained_stress(const TriangleMesh& mesh, std::int32_t v) const;
  /// Follows TriangleMesh::slide of v by t of the way to `toward`: v takes u from between the two
  /// and the faces of its star have the unstrained stress given, from before the slide, and what
  /// the displacements now make of it.
  void follow_slide(const TriangleMesh& mesh, std::int32_t v, std::int32_t toward, double t,
                    const std::vector<Sym3>& unstrained);

  void renumber(const Numbering& numbering);
  void shrink_to_fit();
  Element make_element(const TriangleMesh& mesh, std::int32_t f) const;
  void update_node_area(const TriangleMesh& mesh, std::int32_t v);

  double cap_;
  std::vector<double> adhesion_;      // per source face; empty: 1
  std::vector<Element> elements_;     // #F
  std::vector<Vec4d> forces_;         // #V
  std::vector<Vec4d> displacements_;  // #V
  std::vector<Vec3> normals_;         // #V
  std::vector<double> node_areas_;    // #V
  std::vector<char> held_;            // #V, or empty: none is
};

/// [IO06 Eq. 1] The force of an element on its corner 0, 1 or 2.
inline Vec3 element_force(const Element& e, int corner) {
  const Vec3 f1 = -(e.t[0] * e.edge1() + e.t[2] * e.edge2());
  const Vec3 f2 = -(e.t[2] * e.edge1() + e.t[1] * e.edge2());
  return corner == 1 ? f1 : corner == 2 ? f2 : Vec3(-f1 - f2);
}

}  // namespace craze
