#include "craze/model/relaxation/relaxation_steps.h"

#include <algorithm>

#include "craze/base/parallel.h"

namespace craze {

namespace {

struct NodeArrays {
  Vec4f* forces;
  Vec4f* steps;
  Vec4f* sums;
  Vec4f* changes[ActiveElements::lanes];
  const float* adhesion;
  const char* held;
};

/// Takes the changes of force collected in the lanes of `touched`, then makes the step. Returns
/// whether any of the nodes moves.
CRAZE_WIDE bool step_nodes(const NodeArrays& nodes, std::int32_t begin, std::int32_t end,
                           unsigned touched, const RelaxationStep& step, double rest_force) {
  for (int lane = 0; lane < ActiveElements::lanes; ++lane) {
    if ((touched >> lane & 1) == 0) continue;
    Vec4f* const changes = nodes.changes[lane];
    for (std::int32_t v = begin; v < end; ++v) {
      nodes.forces[v].v += changes[v].v;
      changes[v].v = Vec4f::Lanes{0, 0, 0, 0};
    }
  }
  const auto momentum = static_cast<float>(step.momentum), dt = static_cast<float>(step.time_step);
  const auto weight = static_cast<float>(step.weight);
  const float rest = dt * static_cast<float>(rest_force);
  bool any = false;
  for (std::int32_t v = begin; v < end; ++v) {
    const Vec4f::Lanes last = nodes.steps[v].v;
    const Vec4f::Lanes force = nodes.forces[v].v - nodes.adhesion[v] * last;
    Vec4f::Lanes next = momentum * last + dt * force;
    const Vec4f::Lanes squares = next * next;
    const bool moves = squares[0] + squares[1] + squares[2] > rest * rest && nodes.held[v] == 0;
    next *= moves ? 1.0F : 0.0F;
    any = any || moves;
    nodes.forces[v].v = force;
    nodes.steps[v].v = next;
    nodes.sums[v].v += weight * next;
  }
  return any;
}

template <class Body>
void for_node_blocks(const Threads& threads, std::size_t nodes, const Body& body) {
  constexpr std::size_t size = ElementBlocks::nodes_per_block;
  parallel_for(threads, (nodes + size - 1) / size, ElementBlocks::blocks_per_chunk,
               [&](std::size_t first, std::size_t last) {
                 for (std::size_t block = first; block < last; ++block) {
                   body(block, static_cast<std::int32_t>(block * size),
                        static_cast<std::int32_t>(std::min(nodes, (block + 1) * size)));
                 }
               });
}

}  // namespace

std::int64_t RelaxationSteps::take(const RelaxationState& state,
                                   const std::vector<RelaxationStep>& steps,
                                   std::vector<Vec4d>& moves, std::vector<char>& moving,
                                   const Threads& threads, const StopQuestion& stop) {
  start(state, threads);
  std::int64_t updated = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (stop && stop()) {
      std::fill(moves.begin(), moves.end(), Vec4d());
      std::fill(moving.begin(), moving.end(), 0);
      return updated;
    }
    if (i > 0) {
      active_.find(state.blocks, moving_);
      if (active_.count() == 0) break;
      change_forces(static_cast<int>(state.field.elements().size()), threads);
      updated += active_.count();
    }
    move_nodes(state, steps[i], i == 0, threads);
  }
  // The changes of the last step are nobody's: forces are made anew from the moves.
  for_node_blocks(threads, moves.size(),
                  [&](std::size_t block, std::int32_t begin, std::int32_t end) {
                    for (std::int32_t v = begin; v < end; ++v) {
                      const Vec4f& sum = sums_[v];
                      moves[v].v = Vec4d::Lanes{sum[0], sum[1], sum[2], 0};
                    }
                    moving[block] = moved_[block];
                  });
  return updated;
}

void RelaxationSteps::start(const RelaxationState& state, const Threads& threads) {
  const std::size_t nodes = state.held.size();
  forces_.resize(nodes);
  steps_.resize(nodes);
  sums_.resize(nodes);
  adhesion_.resize(nodes);
  for (auto& lane : changes_) lane.resize(nodes);
  moving_.assign(state.blocks.node_blocks(), 0);
  moved_.assign(state.blocks.node_blocks(), 0);
  active_.reset();
  const StressField& field = state.field;
  for_node_blocks(threads, nodes, [&](std::size_t, std::int32_t begin, std::int32_t end) {
    for (std::int32_t v = begin; v < end; ++v) {
      const double adhesion = state.adhesion * field.node_areas()[v];
      const Vec3 pull = field.force(v) - adhesion * field.displacement(v);
      forces_[v].v = Vec4f::Lanes{static_cast<float>(pull.x()), static_cast<float>(pull.y()),
                                  static_cast<float>(pull.z()), 0};
      steps_[v].v = sums_[v].v = Vec4f::Lanes{0, 0, 0, 0};
      adhesion_[v] = static_cast<float>(adhesion);
    }
  });
}

void RelaxationSteps::move_nodes(const RelaxationState& state, const RelaxationStep& step,
                                 bool first, const Threads& threads) {
  NodeArrays arrays{forces_.data(),   steps_.data(),    sums_.data(), {},
                    adhesion_.data(), state.held.data()};
  for (int lane = 0; lane < ActiveElements::lanes; ++lane) {
    arrays.changes[lane] = changes_[lane].data();
  }
  for_node_blocks(
      threads, forces_.size(), [&](std::size_t block, std::int32_t begin, std::int32_t end) {
        const unsigned touched = first ? 0 : active_.touched(block);
        // Neither moving nor pulled otherwise than when it was left at rest.
        if (!first && touched == 0 && moving_[block] == 0) return;
        moving_[block] = step_nodes(arrays, begin, end, touched, step, state.rest_force) ? 1 : 0;
        if (moving_[block] != 0) moved_[block] = 1;
      });
}

void RelaxationSteps::change_forces(int faces, const Threads& threads) {
  constexpr std::int32_t packs_per_block = ElementBlocks::elements_per_block / ElementPack::size;
  const std::int32_t packs = (faces + ElementPack::size - 1) / ElementPack::size;
  parallel_for(threads, ActiveElements::lanes, 1, [&](std::size_t lane, std::size_t) {
    active_.for_lane(static_cast<int>(lane), [&](std::int32_t block) {
      const std::int32_t begin = block * packs_per_block;
      add_force_changes(packs_.data(), steps_.data(), changes_[lane].data(), begin,
                        std::min(packs, begin + packs_per_block));
    });
  });
}

}  // namespace craze
