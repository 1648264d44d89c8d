#include "craze/model/element_packs.h"

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

    // [IO06 Eqs. 6, 7] ΔT = N q N
    const Lanes x1 = pack.e1[0].v, y1 = pack.e1[1].v, z1 = pack.e1[2].v;
    const Lanes x2 = pack.e2[0].v, y2 = pack.e2[1].v, z2 = pack.e2[2].v;
    const Lanes q11 = x1 * d1[0] + y1 * d1[1] + z1 * d1[2];
    const Lanes q22 = x2 * d2[0] + y2 * d2[1] + z2 * d2[2];
    const Lanes q12 =
        0.5F * (x1 * d2[0] + y1 * d2[1] + z1 * d2[2] + x2 * d1[0] + y2 * d1[1] + z2 * d1[2]);
    const Lanes n11 = pack.n11.v, n12 = pack.n12.v, n22 = pack.n22.v;
    const Lanes a11 = n11 * q11 + n12 * q12, a12 = n11 * q12 + n12 * q22;
    const Lanes a21 = n12 * q11 + n22 * q12, a22 = n12 * q12 + n22 * q22;
    const Lanes t11 = a11 * n11 + a12 * n12;
    const Lanes t22 = a21 * n12 + a22 * n22;
    const Lanes t12 = a11 * n12 + a12 * n22;

    // [IO06 Eq. 1] −Δf of corners 1 and 2; corner 0 gets minus their sum.
    const Lanes columns1[4] = {t11 * x1 + t12 * x2, t11 * y1 + t12 * y2, t11 * z1 + t12 * z2, {}};
    const Lanes columns2[4] = {t12 * x1 + t22 * x2, t12 * y1 + t22 * y2, t12 * z1 + t22 * z2, {}};
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
  for (int k = 0; k < 3; ++k) {
    pack.e1[k][lane] = static_cast<float>(element.e1[k]);
    pack.e2[k][lane] = static_cast<float>(element.e2[k]);
    pack.corners[k][lane] = mesh.triangle(f)[k];
  }
  pack.n11[lane] = static_cast<float>(element.e1[3]);
  pack.n12[lane] = static_cast<float>(element.e2[3]);
  pack.n22[lane] = static_cast<float>(element.t[3]);
}

}  // namespace craze
