#include "craze/model/relaxation/equilibrium.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "craze/base/cell_grid.h"
#include "craze/base/parallel.h"

namespace craze {

namespace {

// Forces are rounded: a tolerance below that is never reached, and these rounds tell.
constexpr int most_stalled_rounds = 8;
// A node with this part of the squared tolerance left is a seed of a patch.
constexpr double seed_part = 0.25;
// Nodes are asked for this many before they are read.
constexpr std::size_t ahead = 8;

/// |F − κ A u|² in the tangent plane; 0 where the node is held.
double squared_residual(const LayerState& layer, std::int32_t v) {
  if (layer.field.is_held(v)) return 0;
  const Vec3 pull = layer.pull(v);
  const double normal = layer.field.normals()[v].dot(pull);
  return pull.squaredNorm() - normal * normal;
}

}  // namespace

double Equilibrium::allow_drift(std::int32_t v, double force) {
  if (v >= static_cast<std::int32_t>(drift_.size())) {
    drift_.resize(v + 1, 0);
    allowed_.resize(v + 1, 0);
  }
  drift_[v] = 0;
  allowed_[v] = std::max(options_.tolerance, force);
  return allowed_[v];
}

bool Equilibrium::force_added(std::int32_t v, double force) {
  if (v >= static_cast<std::int32_t>(drift_.size())) {
    drift_.resize(v + 1, 0);
    allowed_.resize(v + 1, 0);
  }
  drift_[v] += force;
  pulled_.push_back(v);
  return drift_[v] > allowed_[v];
}

void Equilibrium::release_memory() {
  stiffness_ = TangentStiffness(options_.adhesion);
  patches_ = std::vector<Patch>();
  patch_count_ = 0;
  workshops_.clear();
  for (auto* scratch : {&seed_patch_, &group_}) *scratch = std::vector<std::int32_t>();
}

void Equilibrium::restore(StressField& field, const TriangleMesh& mesh,
                          const std::vector<std::int32_t>& changed, const Threads& threads,
                          std::vector<std::int32_t>& moved, const StopQuestion& stop) {
  assert(options_.adhesion > 0 && options_.reach > 0);
  drift_.resize(mesh.vertex_count(), 0);
  allowed_.resize(mesh.vertex_count(), 0);
  if (stiffness_.empty()) {
    stiffness_.assemble(mesh, field, threads);
  } else if (static_cast<std::int32_t>(changed.size()) < mesh.vertex_count()) {
    stiffness_.update(mesh, field, changed, threads);
  }
  LayerState layer{mesh, field, stiffness_, options_.adhesion, options_.tolerance};
  const double allowed = options_.tolerance * options_.tolerance;
  std::vector<std::int32_t> open;
  double largest = 0;
  pulled_.insert(pulled_.end(), changed.begin(), changed.end());
  std::sort(pulled_.begin(), pulled_.end());
  pulled_.erase(std::unique(pulled_.begin(), pulled_.end()), pulled_.end());
  std::vector<double> residuals(pulled_.size());
  parallel_for(threads, pulled_.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) residuals[i] = squared_residual(layer, pulled_[i]);
  });
  for (std::size_t i = 0; i < pulled_.size(); ++i) {
    if (!(residuals[i] > seed_part * allowed)) continue;
    open.push_back(pulled_[i]);
    largest = std::max(largest, residuals[i]);
  }
  pulled_.clear();
  double best = std::numeric_limits<double>::infinity();
  int stalled = 0;
  double part = 1;  // of the tolerance
  for (bool again = false; !open.empty() && stalled < most_stalled_rounds; again = true) {
    const bool gained = largest < 0.5 * best;
    stalled = gained ? 0 : stalled + 1;
    if (gained) best = largest;
    cluster(mesh, open);
    // What patches that overlap have left adds up, to more than the tolerance where many do. The
    // first time they are far apart, and what little is left between them goes with them.
    if (again) part *= 0.5;
    layer.tolerance = patch_count_ > 1 ? part * options_.tolerance : options_.tolerance;
    solve(layer, !again || patch_count_ == 1, threads, stop);
    apply(field, layer, threads);
    parallel_for(threads, patch_count_, 1, [&](std::size_t i, std::size_t) { review(layer, i); });
    open.clear();
    largest = 0;
    for (std::size_t i = 0; i < patch_count_; ++i) {
      const Patch& patch = patches_[i];
      iterations_ += patch.answer.iterations;
      // A triangulated surface has two faces a node.
      element_updates_ += 2 * patch.answer.node_updates;
      moved.insert(moved.end(), patch.moved.begin(), patch.moved.end());
      open.insert(open.end(), patch.open.begin(), patch.open.end());
      largest = std::max(largest, patch.largest_residual);
    }
    if (stop && stop()) break;
    std::sort(open.begin(), open.end());
    open.erase(std::unique(open.begin(), open.end()), open.end());
  }
  if (!open.empty() && !(stop && stop())) met_tolerance_ = false;
}

void Equilibrium::review(const LayerState& layer, std::size_t index) {
  Patch& patch = patches_[index];
  patch.moved.clear();
  patch.open.clear();
  patch.largest_residual = 0;
  const double allowed = options_.tolerance * options_.tolerance;
  // Where answers overlap, or single precision was not enough, some more may be left to do.
  const std::vector<std::int32_t>& nodes = patch.answer.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i + ahead < nodes.size()) {
      layer.prefetch(nodes[i + ahead]);
      __builtin_prefetch(&drift_[nodes[i + ahead]]);
      __builtin_prefetch(&allowed_[nodes[i + ahead]]);
    }
    const std::int32_t v = nodes[i];
    if (drift_[v] > allowed_[v]) patch.moved.push_back(v);
    const double residual = squared_residual(layer, v);
    if (!(residual > allowed)) continue;
    patch.open.push_back(v);
    patch.largest_residual = std::max(patch.largest_residual, residual);
  }
  for (const std::int32_t v : patch.answer.held) {
    if (drift_[v] > allowed_[v]) patch.moved.push_back(v);
  }
}

void Equilibrium::cluster(const TriangleMesh& mesh, const std::vector<std::int32_t>& seeds) {
  const CellGrid grid(2 * options_.reach);
  std::unordered_map<std::uint64_t, std::vector<std::int32_t>> left;  // seeds, by cell
  for (const std::int32_t v : seeds)
    left[grid.key(mesh.period().wrapped(mesh.position(v)))].push_back(v);
  seed_patch_.resize(mesh.vertex_count(), -1);
  patch_count_ = 0;
  for (const std::int32_t first : seeds) {
    if (seed_patch_[first] >= 0) continue;
    const auto index = static_cast<std::int32_t>(patch_count_);
    if (patches_.size() == patch_count_) patches_.emplace_back();
    Patch& patch = patches_[patch_count_++];
    patch.seeds.assign(1, first);
    seed_patch_[first] = index;
    for (std::size_t i = 0; i < patch.seeds.size(); ++i) {
      const std::int32_t seed = patch.seeds[i];
      const auto join_near = [&](const Vec3& p) {
        grid.for_each_near(p, options_.reach, [&](std::uint64_t key) {
          const auto cell = left.find(key);
          if (cell == left.end()) return;
          std::vector<std::int32_t>& near = cell->second;
          near.erase(std::remove_if(near.begin(), near.end(),
                                    [&](std::int32_t v) {
                                      if (seed_patch_[v] >= 0) return true;
                                      const double squared = mesh.way(seed, v).squaredNorm();
                                      if (squared > options_.reach * options_.reach) return false;
                                      seed_patch_[v] = index;
                                      patch.seeds.push_back(v);
                                      return true;
                                    }),
                     near.end());
        });
      };
      mesh.period().for_each_image(mesh.position(seed), options_.reach, join_near);
    }
  }
}

void Equilibrium::solve(const LayerState& layer, bool takes_all, const Threads& threads,
                        const StopQuestion& stop) {
  // A question is asked in this thread alone: of a single patch, the one that may be large.
  const StopQuestion none;
  const StopQuestion& asked = patch_count_ == 1 ? stop : none;
  parallel_for(threads, patch_count_, 1, [&](std::size_t i, std::size_t) {
    Workshop workshop = workshops_.take(layer.mesh.vertex_count());
    Patch& patch = patches_[i];
    std::swap(workshop.solver.answer(), patch.answer);
    workshop.solver.solve(layer, patch.seeds, static_cast<std::int32_t>(i), takes_all, seed_patch_,
                          workshop.marks, asked);
    std::swap(workshop.solver.answer(), patch.answer);
    workshops_.put_back(std::move(workshop));
  });
  for (std::size_t i = 0; i < patch_count_; ++i) {
    for (const std::int32_t v : patches_[i].seeds) seed_patch_[v] = -1;
  }
}

void Equilibrium::apply(StressField& field, const LayerState& layer, const Threads& threads) {
  // Patches that share no node are applied at the same time, the others after each other.
  group_.resize(layer.mesh.vertex_count(), 0);
  std::vector<std::size_t> waiting(patch_count_), together, rest;
  std::iota(waiting.begin(), waiting.end(), std::size_t{0});
  while (!waiting.empty()) {
    ++groups_;
    together.clear();
    rest.clear();
    for (const std::size_t i : waiting) {
      const PatchAnswer& answer = patches_[i].answer;
      const auto is_taken = [&](std::int32_t v) { return group_[v] == groups_; };
      const bool apart = std::none_of(answer.nodes.begin(), answer.nodes.end(), is_taken) &&
                         std::none_of(answer.held.begin(), answer.held.end(), is_taken);
      (apart ? together : rest).push_back(i);
      if (!apart) continue;
      for (const std::int32_t v : answer.nodes) group_[v] = groups_;
      for (const std::int32_t v : answer.held) group_[v] = groups_;
    }
    parallel_for(threads, together.size(), 1, [&](std::size_t i, std::size_t) {
      Workshop workshop = workshops_.take(layer.mesh.vertex_count());
      apply(field, layer, patches_[together[i]].answer, workshop);
      workshops_.put_back(std::move(workshop));
    });
    waiting = rest;
  }
}

void Equilibrium::apply(StressField& field, const LayerState& layer, const PatchAnswer& answer,
                        Workshop& workshop) {
  // A node that has moved keeps its index in `slot` meanwhile.
  std::vector<std::int32_t>& slot = workshop.marks;
  std::vector<Vec4d>& displacements = workshop.displacements;
  displacements.resize(answer.active);
  for (std::int32_t i = 0; i < answer.active; ++i) {
    const Vec3 d = answer.displacement(layer, i);
    displacements[i].v = Vec4d::Lanes{d.x(), d.y(), d.z(), 0};
    field.displacements()[answer.nodes[i]].v += displacements[i].v;
    slot[answer.nodes[i]] = i;
  }
  std::vector<std::int32_t>& faces = workshop.faces;
  std::size_t count = 0;
  const auto add_faces = [&](const std::vector<std::int32_t>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (i + ahead < nodes.size()) layer.stiffness.prefetch_faces(nodes[i + ahead]);
      const TangentStiffness::Faces own = layer.stiffness.own_faces(nodes[i]);
      const std::size_t copied = std::max(own.count, TangentStiffness::readable_faces);
      if (count + copied > faces.size()) faces.resize(2 * (count + copied));
      // How many there are nobody foresees, so that as many are copied of most nodes.
      std::copy_n(own.first, TangentStiffness::readable_faces, faces.begin() + count);
      for (std::int32_t k = TangentStiffness::readable_faces; k < own.count; ++k)
        faces[count + k] = own.first[k];
      count += own.count;
    }
  };
  add_faces(answer.nodes);
  add_faces(answer.held);
  faces.resize(count);
  field.displace(layer.mesh, workshop.faces, slot, displacements, drift_);
  for (std::int32_t i = 0; i < answer.active; ++i) slot[answer.nodes[i]] = -1;
}

Equilibrium::Workshop Equilibrium::Workshops::take(std::int32_t nodes) {
  Workshop workshop;
  if (const std::lock_guard lock(mutex_); !free_.empty()) {
    workshop = std::move(free_.back());
    free_.pop_back();
  }
  workshop.marks.resize(nodes, -1);
  return workshop;
}

void Equilibrium::Workshops::put_back(Workshop workshop) {
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(workshop));
}

}  // namespace craze
