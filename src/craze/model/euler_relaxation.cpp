#include "craze/model/euler_relaxation.h"

#include <algorithm>

#include "craze/base/parallel.h"
#include "craze/model/element_response.h"

namespace craze {

namespace {

/// [IO06 Eq. 7] σ += Δσ for elements [begin, end), and the change of force that follows.
CRAZE_WIDE void relax_elements(Element* elements, const Triangle* triangles, const Vec4d* moves,
                               Vec4d* force_change, std::int32_t begin, std::int32_t end) {
  for (std::int32_t f = begin; f < end; ++f) {
    const Triangle& corner = triangles[f];
    const Vec4d::Lanes p0 = moves[corner[0]].v;
    const ElementResponse response =
        element_response(elements[f], moves[corner[1]].v - p0, moves[corner[2]].v - p0);
    response.add_stress_to(elements[f]);
    force_change[corner[0]].v += response.f1 + response.f2;
    force_change[corner[1]].v -= response.f1;
    force_change[corner[2]].v -= response.f2;
  }
}

/// Moves the changes of nodes [begin, end) into their forces.
CRAZE_WIDE void take_changes(Vec4d* forces, Vec4d* force_change, std::int32_t begin,
                             std::int32_t end) {
  constexpr Vec4d::Lanes vector_part = {1, 1, 1, 0};
  for (std::int32_t v = begin; v < end; ++v) {
    forces[v].v += vector_part * force_change[v].v;
    force_change[v].v = Vec4d::Lanes{0, 0, 0, 0};
  }
}

constexpr std::size_t blocks_per_chunk = 16;

}  // namespace

EulerRelaxation::EulerRelaxation(const TriangleMesh& mesh, const EulerRelaxationOptions& options)
    : options_(options), moves_(mesh.vertex_count()) {
  for (auto& lane : force_change_) lane.resize(mesh.vertex_count());
}

void EulerRelaxation::run(StressField& field, const TriangleMesh& mesh, const ElementBlocks& blocks,
                          std::int64_t steps, int threads) {
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
  }
  for (int lane = 0; lane < lanes; ++lane) {
    for (std::size_t i = lane_begin(lane); i < lane_begin(lane + 1); ++i) {
      for (const std::int32_t n : blocks.nodes_of(active_[i]))
        touched_[n] = static_cast<unsigned char>(touched_[n] | 1U << lane);
    }
  }
}

void EulerRelaxation::update_stress(StressField& field, const TriangleMesh& mesh, int threads) {
  Element* const elements = field.elements().data();
  const Triangle* const triangles = mesh.triangles().data();
  const std::int32_t faces = mesh.face_count();
  parallel_for(threads, lanes, 1, [&](std::size_t lane, std::size_t) {
    for (std::size_t i = lane_begin(lane); i < lane_begin(lane + 1); ++i) {
      const std::int32_t begin = active_[i] * ElementBlocks::elements_per_block;
      relax_elements(elements, triangles, moves_.data(), force_change_[lane].data(), begin,
                     std::min(faces, begin + ElementBlocks::elements_per_block));
    }
  });
  element_updates_ += static_cast<std::int64_t>(active_.size()) * ElementBlocks::elements_per_block;
}

void EulerRelaxation::collect_forces(StressField& field, int threads) {
  const auto nodes = static_cast<std::int32_t>(moves_.size());
  Vec4d* const forces = field.forces().data();
  parallel_for(threads, touched_.size(), blocks_per_chunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t block = b; block < e; ++block) {
      const unsigned touched = touched_[block];
      if (touched == 0) continue;
      touched_[block] = 0;
      changed_[block] = 1;
      const auto begin = static_cast<std::int32_t>(block) * ElementBlocks::nodes_per_block;
      const auto end = std::min(nodes, begin + ElementBlocks::nodes_per_block);
      for (int lane = 0; lane < lanes; ++lane) {
        if ((touched >> lane & 1) == 0) continue;
        take_changes(forces, force_change_[lane].data(), begin, end);
      }
    }
  });
}

}  // namespace craze
