#include "craze/model/relaxation/element_packs.h"

#include <numbers>

namespace craze {

namespace {

using Lanes = Vec8f::Lanes;

/// Rows x y z w of elements 0|4, 1|5, 2|6, 3|7 to columns x, y, z, w of elements 0…7, and back.
inline void transpose(const Lanes (&in)[4], Lanes (&out)[4]) {
  const Lanes low01 = __builtin_shufflevector(in[0], in[1], 0, 8, 1, 9, 4, 12, 5, 13);
  const Lanes high01 = __builtin_shufflevector(in[0], in[1], 2, 10, 3, 11, 6, 14, 7, 15);
  const Lanes low23 = __builtin_shufflevector(in[2], in[3], 0, 8, 1, 9, 4, 12, 5, 13);
  const Lanes high23 = __builtin_shufflevector(in[2], in[3], 2, 10, 3, 11, 6, 14, 7, 15);
  out[0] = __builtin_shufflevector(low01, low23, 0, 1, 8, 9, 4, 5, 12, 13);
  out[1] = __builtin_shufflevector(low01, low23, 2, 3, 10, 11, 6, 7, 14, 15);
  out[2] = __builtin_shufflevector(high01, high23, 0, 1, 8, 9, 4, 5, 12, 13);
  out[3] = __builtin_shufflevector(high01, high23, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// Displacements of one corner less that of corner 0, as columns.
inline void gather(const Vec4f* moves, const std::int32_t* corner, const std::int32_t* corner0,
                   Lanes (&columns)[4]) {
  Lanes rows[4];
  for (int i = 0; i < 4; ++i) {
    const Vec4f::Lanes low = moves[corner[i]].v - moves[corner0[i]].v;
    const Vec4f::Lanes high = moves[corner[i + 4]].v - moves[corner0[i + 4]].v;
    rows[i] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  transpose(rows, columns);
}

}  // namespace

CRAZE_WIDE void add_force_changes(const ElementPack* packs, const Vec4f* moves, Vec4f* force_change,
                                  std::int32_t begin, std::int32_t end) {
  for (std::int32_t p = begin; p < end; ++p) {
    const ElementPack& pack = packs[p];
    const auto& corners = pack.corners;
    Lanes d1[4], d2[4];
    gather(moves, corners[1], corners[0], d1);
    gather(moves, corners[2], corners[0], d2);

    // [IO06 Eqs. 6, 7, then Eq. 1] With D = Σ d_j ∇λ_jᵀ and P the projection into the plane,
    // A Δσ ∇λ_i = A/2 (P D + Dᵀ P) ∇λ_i, −Δf of corners 1 and 2; corner 0 gets minus their sum.
    Lanes g1[3], g2[3], n[3];
    for (int k = 0; k < 3; ++k) {
      g1[k] = pack.g1[k].v;
      g2[k] = pack.g2[k].v;
      n[k] = pack.normal[k].v;
    }
    const Lanes g11 = g1[0] * g1[0] + g1[1] * g1[1] + g1[2] * g1[2];
    const Lanes g12 = g1[0] * g2[0] + g1[1] * g2[1] + g1[2] * g2[2];
    const Lanes g22 = g2[0] * g2[0] + g2[1] * g2[1] + g2[2] * g2[2];
    const Lanes d11 = d1[0] * g1[0] + d1[1] * g1[1] + d1[2] * g1[2];
    const Lanes d12 = d1[0] * g2[0] + d1[1] * g2[1] + d1[2] * g2[2];
    const Lanes d21 = d2[0] * g1[0] + d2[1] * g1[1] + d2[2] * g1[2];
    const Lanes d22 = d2[0] * g2[0] + d2[1] * g2[1] + d2[2] * g2[2];
    const Lanes up1 = d1[0] * n[0] + d1[1] * n[1] + d1[2] * n[2];
    const Lanes up2 = d2[0] * n[0] + d2[1] * n[1] + d2[2] * n[2];
    Lanes columns1[4] = {}, columns2[4] = {};
    for (int k = 0; k < 3; ++k) {
      const Lanes flat1 = d1[k] - up1 * n[k], flat2 = d2[k] - up2 * n[k];
      columns1[k] = flat1 * g11 + flat2 * g12 + g1[k] * d11 + g2[k] * d21;
      columns2[k] = flat1 * g12 + flat2 * g22 + g1[k] * d12 + g2[k] * d22;
    }
    Lanes f1[4], f2[4];
    transpose(columns1, f1);
    transpose(columns2, f2);
    for (int i = 0; i < 4; ++i) {
      const Lanes sum = f1[i] + f2[i];
      force_change[corners[0][i]].v += __builtin_shufflevector(sum, sum, 0, 1, 2, 3);
      force_change[corners[1][i]].v -= __builtin_shufflevector(f1[i], f1[i], 0, 1, 2, 3);
      force_change[corners[2][i]].v -= __builtin_shufflevector(f2[i], f2[i], 0, 1, 2, 3);
      force_change[corners[0][i + 4]].v += __builtin_shufflevector(sum, sum, 4, 5, 6, 7);
      force_change[corners[1][i + 4]].v -= __builtin_shufflevector(f1[i], f1[i], 4, 5, 6, 7);
      force_change[corners[2][i + 4]].v -= __builtin_shufflevector(f2[i], f2[i], 4, 5, 6, 7);
    }
  }
}

void ElementPacks::update(const TriangleMesh& mesh, const StressField& field,
                          const std::vector<std::int32_t>& changed_nodes) {
  packs_.resize((mesh.face_count() + ElementPack::size - 1) / ElementPack::size);
  for (; faces_ < mesh.face_count(); ++faces_) set(mesh, field, faces_);
  for (const std::int32_t v : changed_nodes) {
    mesh.for_each_outgoing(v, [&](std::int32_t h) { set(mesh, field, h / 3); });
  }
}

void ElementPacks::set(const TriangleMesh& mesh, const StressField& field, std::int32_t f) {
  ElementPack& pack = packs_[f / ElementPack::size];
  const int lane = f % ElementPack::size;
  const Element& element = field.elements()[f];
  const Vec3 e1 = element.edge1(), e2 = element.edge2();
  const double n11 = element.e1[3], n12 = element.e2[3], n22 = element.t[3];
  const Vec3 g1 = (n11 * e1 + n12 * e2) / std::numbers::sqrt2;
  const Vec3 g2 = (n12 * e1 + n22 * e2) / std::numbers::sqrt2;
  const Vec3 normal = e1.cross(e2).normalized();
  for (int k = 0; k < 3; ++k) {
    pack.g1[k][lane] = static_cast<float>(g1[k]);
    pack.g2[k][lane] = static_cast<float>(g2[k]);
    pack.normal[k][lane] = static_cast<float>(normal[k]);
    pack.corners[k][lane] = mesh.triangle(f)[k];
  }
}

}  // namespace craze
