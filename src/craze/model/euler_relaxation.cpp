#include "craze/model/euler_relaxation.h"

#include <algorithm>

#include "craze/base/parallel.h"

namespace craze {

namespace {

/// [IO06 Eqs. 6, 7] and Eq. 1 for the change of stress, over elements [begin, end). With the edges
/// e_a as the material basis, ∂ε_ab/∂p Δp = ½ (e_a·Δe_b + e_b·Δe_a), Δe_a = Δp_a − Δp_0.
CRAZE_WIDE void relax_elements(Element* elements, const Triangle* triangles, const Vec4d* moves,
                               Vec4d* force_change, std::int32_t begin, std::int32_t end) {
  for (std::int32_t f = begin; f < end; ++f) {
    const Triangle& corner = triangles[f];
    Element& element = elements[f];
    const Vec4d::Lanes e1 = element.e1.v, e2 = element.e2.v, t = element.t.v;
    const Vec4d::Lanes p0 = moves[corner[0]].v;
    const Vec4d::Lanes d1 = moves[corner[1]].v - p0, d2 = moves[corner[2]].v - p0;

    const Vec4d::Lanes m11 = e1 * d1, m22 = e2 * d2, m12 = e1 * d2 + e2 * d1;
    const double q11 = m11[0] + m11[1] + m11[2];
    const double q22 = m22[0] + m22[1] + m22[2];
    const double q12 = 0.5 * (m12[0] + m12[1] + m12[2]);

    // ΔT = N q N
    const double n11 = e1[3], n12 = e2[3], n22 = t[3];
    const double a11 = n11 * q11 + n12 * q12, a12 = n11 * q12 + n12 * q22;
    const double a21 = n12 * q11 + n22 * q12, a22 = n12 * q12 + n22 * q22;
    const double t11 = a11 * n11 + a12 * n12;
    const double t22 = a21 * n12 + a22 * n22;
    const double t12 = a11 * n12 + a12 * n22;
    element.t.v = t + Vec4d::Lanes{t11, t22, t12, 0};

    const Vec4d::Lanes f1 = t11 * e1 + t12 * e2, f2 = t12 * e1 + t22 * e2;
    force_change[corner[0]].v += f1 + f2;
    force_change[corner[1]].v -= f1;
    force_change[corner[2]].v -= f2;
  }
}

constexpr std::size_t blocks_per_chunk = 16;

}  // namespace

EulerRelaxation::EulerRelaxation(const TriangleMesh& mesh, const EulerRelaxationOptions& options)
    : options_(options), moves_(mesh.vertex_count()) {
  for (auto& lane : force_change_) lane.resize(mesh.vertex_count());
}

void EulerRelaxation::run(StressField& field, const TriangleMesh& mesh,
                          const ElementBlocks& blocks, std::int64_t steps, int threads) {
  moves_.resize(mesh.vertex_count());
  for (auto& lane : force_change_) lane.resize(mesh.vertex_count());
  block_force_.resize(blocks.node_blocks(), 0);
  touched_.resize(blocks.node_blocks(), 0);
  changed_.resize(blocks.node_blocks(), 0);
  for (std::int64_t step = 0; step < steps; ++step) {
    move_nodes(field, blocks, threads);
    if (largest_force_ == 0) return;
    update_stress(field, mesh, threads);
    collect_forces(field, threads);
  }
}

void EulerRelaxation::move_nodes(StressField& field, const ElementBlocks& blocks, int threads) {
  const auto nodes = static_cast<std::int32_t>(moves_.size());
  const double dt = options_.time_step, kappa = options_.adhesion;
  const double rest = options_.rest_force * options_.rest_force;
  Vec4d* const moves = moves_.data();
  const Vec4d* const forces = field.forces().data();
  Vec4d* const displacements = field.displacements().data();
  const double* const areas = field.node_areas().data();
  const auto fixed_count = static_cast<std::int32_t>(fixed.size());

  parallel_for(threads, block_force_.size(), blocks_per_chunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t block = b; block < e; ++block) {
      const auto begin = static_cast<std::int32_t>(block) * ElementBlocks::nodes_per_block;
      const auto end = std::min(nodes, begin + ElementBlocks::nodes_per_block);
      double largest = 0;
      for (std::int32_t v = begin; v < end; ++v) {
        Vec4d::Lanes force = forces[v].v - kappa * areas[v] * displacements[v].v;
        const double squared = force[0] * force[0] + force[1] * force[1] + force[2] * force[2];
        const bool moves_now = squared > rest && !(v < fixed_count && fixed[v]);
        largest = std::max(largest, moves_now ? squared : 0.0);
        // [IO06 Eq. 3] Δp = Δt F
        moves[v].v = (moves_now ? dt : 0.0) * force;
        displacements[v].v += moves[v].v;
      }
      block_force_[block] = largest;
    }
  });
  largest_force_ = 0;
  for (const double f : block_force_) largest_force_ = std::max(largest_force_, f);
  largest_force_ = std::sqrt(largest_force_);

  active_.clear();
  for (std::int32_t block = 0; block < blocks.element_blocks(); ++block) {
    const auto& touched = blocks.nodes_of(block);
    if (std::none_of(touched.begin(), touched.end(),
                     [&](std::int32_t n) { return block_force_[n] > 0; })) {
      continue;
    }
    active_.push_back(block);
    for (const std::int32_t n : touched) touched_[n] = 1;
  }
}

void EulerRelaxation::update_stress(StressField& field, const TriangleMesh& mesh, int threads) {
  Element* const elements = field.elements().data();
  const Triangle* const triangles = mesh.triangles().data();
  const std::int32_t faces = mesh.face_count();
  const std::size_t active = active_.size();
  parallel_for(threads, lanes, 1, [&](std::size_t lane, std::size_t) {
    for (std::size_t i = active * lane / lanes; i < active * (lane + 1) / lanes; ++i) {
      const std::int32_t begin = active_[i] * ElementBlocks::elements_per_block;
      relax_elements(elements, triangles, moves_.data(), force_change_[lane].data(), begin,
                     std::min(faces, begin + ElementBlocks::elements_per_block));
    }
  });
  element_updates_ += static_cast<std::int64_t>(active) * ElementBlocks::elements_per_block;
}

void EulerRelaxation::collect_forces(StressField& field, int threads) {
  const auto nodes = static_cast<std::int32_t>(moves_.size());
  Vec4d* const forces = field.forces().data();
  parallel_for(threads, touched_.size(), blocks_per_chunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t block = b; block < e; ++block) {
      if (!touched_[block]) continue;
      touched_[block] = 0;
      changed_[block] = 1;
      const auto begin = static_cast<std::int32_t>(block) * ElementBlocks::nodes_per_block;
      const auto end = std::min(nodes, begin + ElementBlocks::nodes_per_block);
      for (std::int32_t v = begin; v < end; ++v) {
        Vec4d::Lanes sum = {0, 0, 0, 0};
        for (auto& lane : force_change_) {
          sum += lane[v].v;
          lane[v].v = Vec4d::Lanes{0, 0, 0, 0};
        }
        sum[3] = 0;
        forces[v].v += sum;
      }
    }
  });
}

}  // namespace craze
