#include "craze/model/relaxation/tangent_stiffness.h"

#include <algorithm>
#include <cmath>

#include "craze/base/parallel.h"

namespace craze {

namespace {

// What a new row has room for beyond its first neighbours, so that a split nearby fits in.
constexpr std::int32_t spare_blocks = 1;

}  // namespace

PlaneBasis::PlaneBasis(const Vec3& n) {
  const double sign = std::copysign(1.0, n.z());
  const double s = -1 / (sign + n.z()), t = n.x() * n.y() * s;
  a = {1 + sign * n.x() * n.x() * s, sign * t, -sign * n.x()};
  b = {t, sign + n.y() * n.y() * s, -n.y()};
}

void TangentStiffness::assemble(const TriangleMesh& mesh, const StressField& field,
                                const Threads& threads) {
  rows_.assign(mesh.vertex_count(), {});
  columns_.clear();
  faces_.clear();
  blocks_.clear();
  // A closed surface has six edges a node; some more for cracks, to which memory that nothing is
  // written to costs less than copying all of it.
  constexpr std::size_t typical_row = 11;
  columns_.reserve(typical_row * mesh.vertex_count());
  faces_.reserve(typical_row * mesh.vertex_count());
  blocks_.reserve(typical_row * mesh.vertex_count());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) make_room(mesh, v, 0);
  constexpr std::size_t grain = 512;
  parallel_for(threads, rows_.size(), grain, [&](std::size_t begin, std::size_t end) {
    Draft draft;
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<std::int32_t>(i);
      draft_row(mesh, field, v, draft);
      store_row(mesh, v, draft);
    }
  });
}

void TangentStiffness::update(const TriangleMesh& mesh, const StressField& field,
                              const std::vector<std::int32_t>& nodes, const Threads& threads) {
  rows_.resize(mesh.vertex_count());
  touched_.clear();
  for (const std::int32_t v : nodes) {
    touched_.push_back(v);
    mesh.for_each_outgoing(v, [&](std::int32_t h) {
      touched_.push_back(mesh.to(h));
      touched_.push_back(mesh.from(TriangleMesh::prev(h)));
    });
  }
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  for (const std::int32_t v : touched_) make_room(mesh, v, spare_blocks);
  parallel_for(threads, touched_.size(), 64, [&](std::size_t begin, std::size_t end) {
    Draft draft;
    for (std::size_t i = begin; i < end; ++i) {
      draft_row(mesh, field, touched_[i], draft);
      store_row(mesh, touched_[i], draft);
    }
  });
}

void TangentStiffness::draft_row(const TriangleMesh& mesh, const StressField& field, std::int32_t v,
                                 Draft& draft) const {
  const PlaneBasis basis(field.normals()[v]);
  const double mass = adhesion_ * field.node_areas()[v];
  draft.columns.assign(1, v);
  draft.blocks.assign(1, {mass, 0, 0, mass});
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    // g_a = Σ_b N_ab e_b = √√A ∇λ_a, and K_ab = ½ (g_b g_aᵀ + (g_a·g_b) P), P the projection on the
    // element's plane: Eqs. 6, 7 and 1 put together.
    const Element& e = field.elements()[h / 3];
    const Vec3 g1 = e.e1[3] * e.edge1() + e.e2[3] * e.edge2();
    const Vec3 g2 = e.e2[3] * e.edge1() + e.t[3] * e.edge2();
    const Vec3 g[3] = {-g1 - g2, g1, g2};
    const Vec3 normal = g1.cross(g2);
    const double squared = normal.squaredNorm();
    if (!(squared > 0)) return;
    const Vec3& ga = g[h % 3];
    for (int k = 0; k < 3; ++k) {
      const int corner = (h + k) % 3;
      const std::int32_t n = mesh.triangle(h / 3)[corner];
      const PlaneBasis other(field.normals()[n]);
      const Vec3& gb = g[corner];
      const double c = ga.dot(gb);
      const auto entry = [&](const Vec3& mine, const Vec3& its) {
        const double projected = mine.dot(its) - mine.dot(normal) * normal.dot(its) / squared;
        return 0.5 * (mine.dot(gb) * ga.dot(its) + c * projected);
      };
      const std::array<double, 4> block = {entry(basis.a, other.a), entry(basis.a, other.b),
                                           entry(basis.b, other.a), entry(basis.b, other.b)};
      const auto found = std::find(draft.columns.begin(), draft.columns.end(), n);
      const auto slot = static_cast<std::size_t>(found - draft.columns.begin());
      if (found == draft.columns.end()) {
        draft.columns.push_back(n);
        draft.blocks.push_back(block);
      } else {
        for (int i = 0; i < 4; ++i) draft.blocks[slot][i] += block[i];
      }
    }
  });
}

void TangentStiffness::make_room(const TriangleMesh& mesh, std::int32_t v, std::int32_t spare) {
  std::int32_t count = mesh.is_open_vertex(v) ? 2 : 1;  // itself, and a neighbour more than faces
  mesh.for_each_outgoing(v, [&](std::int32_t) { ++count; });
  Extent& extent = rows_[v];
  if (count <= extent.capacity) return;
  extent.begin = static_cast<std::uint32_t>(columns_.size());
  extent.capacity = count + spare;
  columns_.resize(columns_.size() + extent.capacity, -1);
  faces_.resize(columns_.size() + readable_faces, -1);
  blocks_.resize(blocks_.size() + extent.capacity);
}

void TangentStiffness::store_row(const TriangleMesh& mesh, std::int32_t v, const Draft& draft) {
  Extent& extent = rows_[v];
  extent.count = static_cast<std::int32_t>(draft.columns.size());
  extent.faces = 0;
  mesh.for_each_outgoing(v, [&](std::int32_t h) {
    const Triangle& t = mesh.triangle(h / 3);
    if (v <= t[0] && v <= t[1] && v <= t[2]) faces_[extent.begin + extent.faces++] = h / 3;
  });
  for (std::int32_t i = 0; i < extent.count; ++i) {
    columns_[extent.begin + i] = draft.columns[i];
    Vec4f& block = blocks_[extent.begin + i];
    for (int k = 0; k < 4; ++k) block[k] = static_cast<float>(draft.blocks[i][k]);
  }
}

}  // namespace craze
