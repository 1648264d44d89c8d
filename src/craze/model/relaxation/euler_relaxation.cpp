#include "craze/model/relaxation/euler_relaxation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "craze/base/parallel.h"
#include "craze/model/element_response.h"

namespace craze {

namespace {

constexpr Vec4d::Lanes vector_part = {1, 1, 1, 0};

/// [IO06 Eq. 7] σ += Δσ for elements [begin, end), and the change of force that follows.
CRAZE_WIDE void relax_elements(Element* elements, const Triangle* triangles, const Vec4d* moves,
                               Vec4d* force_change, std::int32_t begin, std::int32_t end) {
  for (std::int32_t f = begin; f < end; ++f) {
    const Triangle& corner = triangles[f];
    const Vec4d::Lanes p0 = moves[corner[0]].v;
    const ElementResponse response =
        element_response(elements[f], moves[corner[1]].v - p0, moves[corner[2]].v - p0);
    response.add_stress_to(elements[f]);
    const Vec4d::Lanes f1 = vector_part * response.f1, f2 = vector_part * response.f2;
    const Vec4d::Lanes bound = {0, 0, 0, response.force_bound()};
    force_change[corner[0]].v += bound + f1 + f2;
    force_change[corner[1]].v += bound - f1;
    force_change[corner[2]].v += bound - f2;
  }
}

/// Moves the changes of nodes [begin, end) into their forces.
CRAZE_WIDE void take_changes(Vec4d* forces, double* drift, Vec4d* force_change, std::int32_t begin,
                             std::int32_t end) {
  for (std::int32_t v = begin; v < end; ++v) {
    forces[v].v += vector_part * force_change[v].v;
    drift[v] += force_change[v].v[3];
    force_change[v].v = Vec4d::Lanes{0, 0, 0, 0};
  }
}

// Rounding is put right after as many Euler steps.
constexpr double most_euler_steps = 64;
// The bound on the stiffness creeps up with every sliver that a cut makes; this much room saves
// making the steps anew each time.
constexpr double stiffness_room = 1.05;

}  // namespace

EulerRelaxation::EulerRelaxation(const TriangleMesh& mesh, const StressField& field,
                                 const EulerRelaxationOptions& options)
    : options_(options), blocks_(mesh), stiffness_(options.accelerated ? 0 : options.adhesion) {
  assert(options.time_step > 0 && options.adhesion >= 0);
  steps_.update(mesh, field, {});
  stiffness_.update(mesh, field);
}

void EulerRelaxation::mesh_changed(const TriangleMesh& mesh, const StressField& field,
                                   const std::vector<std::int32_t>& faces,
                                   const std::vector<std::int32_t>& nodes) {
  blocks_.update(mesh, faces);
  steps_.update(mesh, field, nodes);
  stiffness_.update(mesh, field, nodes);
  active_.reset();
}

double EulerRelaxation::allow_drift(std::int32_t v, double force) {
  if (v >= static_cast<std::int32_t>(drift_.size())) {
    drift_.resize(v + 1, 0);
    allowed_.resize(v + 1, 0);
  }
  drift_[v] = 0;
  allowed_[v] = force;
  return force;
}

void EulerRelaxation::drifted(std::vector<std::int32_t>& nodes) const {
  const auto count = static_cast<std::int32_t>(drift_.size());
  for (std::int32_t v = 0; v < count; ++v) {
    if (drift_[v] > allowed_[v]) nodes.push_back(v);
  }
}

void EulerRelaxation::run(StressField& field, const TriangleMesh& mesh, std::int64_t steps,
                          const Threads& threads, const StopQuestion& stop) {
  steps_left_ = static_cast<double>(steps) * parts_of_a_step();
  resume(field, mesh, threads, stop);
}

void EulerRelaxation::resume(StressField& field, const TriangleMesh& mesh, const Threads& threads,
                             const StopQuestion& stop) {
  resize(field);
  constexpr double none_left = 1e-6;
  // Ends: every pass takes at least one of the steps, or an equal part of all.
  while (steps_left_ > none_left) {
    const double taken = next_steps(steps_left_);
    move_nodes(field, schedule_[0].time_step, threads);
    if (largest_force_ == 0) break;
    if (stop && stop()) return;
    if (schedule_.size() > 1) {
      element_updates_ +=
          ElementBlocks::elements_per_block *
          steps_.take({field, blocks_, held_, options_.adhesion, options_.rest_force}, schedule_,
                      moves_, moving_, threads, stop);
    }
    if (stop && stop()) return;  // and nothing has moved
    apply_moves(field, mesh, threads);
    steps_left_ -= taken;
  }
  steps_left_ = 0;
}

void EulerRelaxation::resize(const StressField& field) {
  const std::size_t nodes = field.forces().size();
  held_.resize(nodes);
  for (std::size_t v = 0; v < nodes; ++v) held_[v] = field.is_held(static_cast<std::int32_t>(v));
  moves_.resize(nodes);
  for (auto& lane : changes_) lane.resize(nodes);
  drift_.resize(nodes, 0);
  allowed_.resize(nodes, 0);
  moving_.resize(blocks_.node_blocks());
  block_force_.resize(blocks_.node_blocks());
}

double EulerRelaxation::parts_of_a_step() const {
  if (options_.accelerated) return 1;
  return std::max(1.0, std::ceil(0.5 * options_.time_step * stiffness_.value()));
}

/// Makes the schedule of the next few steps and returns how many they stand for.
double EulerRelaxation::next_steps(double remaining) {
  const double dt = step_size();
  double count = std::min(remaining, most_euler_steps);
  const bool accelerated = options_.accelerated && stiffness_.value() > 0;
  if (accelerated) {
    if (stiffness_.value() > scheduled_stiffness_) {
      scheduled_stiffness_ = stiffness_room * stiffness_.value();
      scheduled_steps_ = 0;
    }
    const double parts = std::ceil(remaining / most_steps_at_once(dt, scheduled_stiffness_));
    count = parts > 1 ? remaining / parts : remaining;
    if (steps_are_stable()) count = std::ceil(count);
  }
  if (count == scheduled_steps_ && dt == scheduled_step_) return count;
  scheduled_steps_ = count;
  scheduled_step_ = dt;
  if (accelerated) schedule_ = accelerated_steps(count, dt, scheduled_stiffness_);
  if (!accelerated || (steps_are_stable() && count <= static_cast<double>(schedule_.size()) + 1)) {
    schedule_ = euler_steps(std::llround(count), dt);
  }
  return count;
}

void EulerRelaxation::move_nodes(const StressField& field, double time_step,
                                 const Threads& threads) {
  const auto nodes = static_cast<std::int32_t>(moves_.size());
  const double rest = options_.rest_force * options_.rest_force;
  parallel_for(
      threads, block_force_.size(), ElementBlocks::blocks_per_chunk,
      [&](std::size_t b, std::size_t e) {
        for (std::size_t block = b; block < e; ++block) {
          const auto begin = static_cast<std::int32_t>(block) * ElementBlocks::nodes_per_block;
          const auto end = std::min(nodes, begin + ElementBlocks::nodes_per_block);
          double largest = 0;
          for (std::int32_t v = begin; v < end; ++v) {
            const Vec4d::Lanes force = field.forces()[v].v - options_.adhesion *
                                                                 field.node_areas()[v] *
                                                                 field.displacements()[v].v;
            const double squared = force[0] * force[0] + force[1] * force[1] + force[2] * force[2];
            const bool moves = squared > rest && held_[v] == 0;
            largest = std::max(largest, moves ? squared : 0.0);
            // [IO06 Eq. 3] Δp = Δt F
            moves_[v].v = (moves ? time_step : 0.0) * vector_part * force;
          }
          block_force_[block] = largest;
          moving_[block] = largest > 0 ? 1 : 0;
        }
      });
  largest_force_ = 0;
  for (const double f : block_force_) largest_force_ = std::max(largest_force_, f);
  largest_force_ = std::sqrt(largest_force_);
}

/// u += Δu, σ and F with it.
void EulerRelaxation::apply_moves(StressField& field, const TriangleMesh& mesh,
                                  const Threads& threads) {
  active_.find(blocks_, moving_);
  Element* const elements = field.elements().data();
  const Triangle* const triangles = mesh.triangles().data();
  const std::int32_t faces = mesh.face_count();
  parallel_for(threads, ActiveElements::lanes, 1, [&](std::size_t lane, std::size_t) {
    active_.for_lane(static_cast<int>(lane), [&](std::int32_t block) {
      const std::int32_t begin = block * ElementBlocks::elements_per_block;
      relax_elements(elements, triangles, moves_.data(), changes_[lane].data(), begin,
                     std::min(faces, begin + ElementBlocks::elements_per_block));
    });
  });
  element_updates_ += active_.count() * ElementBlocks::elements_per_block;

  const auto nodes = static_cast<std::int32_t>(moves_.size());
  Vec4d* const forces = field.forces().data();
  Vec4d* const displacements = field.displacements().data();
  parallel_for(
      threads, moving_.size(), ElementBlocks::blocks_per_chunk, [&](std::size_t b, std::size_t e) {
        for (std::size_t block = b; block < e; ++block) {
          const auto begin = static_cast<std::int32_t>(block) * ElementBlocks::nodes_per_block;
          const auto end = std::min(nodes, begin + ElementBlocks::nodes_per_block);
          for (int lane = 0; lane < ActiveElements::lanes; ++lane) {
            if ((active_.touched(block) >> lane & 1) == 0) continue;
            take_changes(forces, drift_.data(), changes_[lane].data(), begin, end);
          }
          if (moving_[block] == 0) continue;
          for (std::int32_t v = begin; v < end; ++v) displacements[v].v += moves_[v].v;
        }
      });
}

}  // namespace craze
