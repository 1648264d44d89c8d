#include "craze/model/equilibrium.h"

#include <algorithm>

#include "craze/base/parallel.h"

namespace craze {

namespace {

/// |F − κ A u|² in the tangent plane; 0 where the node is held.
double squared_residual(const LayerState& layer, std::int32_t v) {
  if (layer.is_fixed(v)) return 0;
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

void Equilibrium::restore(StressField& field, const TriangleMesh& mesh,
                          const std::vector<std::int32_t>& changed, int threads,
                          std::vector<std::int32_t>& moved) {
  mark_.resize(mesh.vertex_count(), -1);
  drift_.resize(mesh.vertex_count(), 0);
  allowed_.resize(mesh.vertex_count(), 0);
  if (stiffness_.empty()) {
    stiffness_.assemble(mesh, field);
  } else if (static_cast<std::int32_t>(changed.size()) < mesh.vertex_count()) {
    stiffness_.update(mesh, field, changed);
  }
  const LayerState layer{mesh, field, stiffness_, fixed, options_.adhesion};
  const double allowed = options_.tolerance * options_.tolerance;
  std::vector<std::int32_t> open;
  for (const std::int32_t v : changed) {
    if (squared_residual(layer, v) > 0.25 * allowed) open.push_back(v);
  }
  for (double radius = options_.radius; !open.empty(); radius *= 1.5) {
    cluster_seeds(mesh, open, 2 * (radius + options_.longest_edge));
    parallel_for(threads, patch_count_, 1, [&](std::size_t i, std::size_t) {
      Patch& patch = patches_[i];
      patch.solver.solve(layer, patch.seeds, options_.tolerance, radius, mark_);
      apply(field, layer, patch);
    });
    // Whatever a patch pushed out over its rim is a change there: go on from it.
    open.clear();
    for (std::size_t i = 0; i < patch_count_; ++i) {
      const PatchSolver& solver = patches_[i].solver;
      iterations_ += solver.iterations();
      // A triangulated surface has two faces a node.
      element_updates_ += 2 * solver.node_updates();
      const auto look_at = [&](std::int32_t v, bool may_be_open) {
        if (drift_[v] > allowed_[v]) moved.push_back(v);
        if (may_be_open && squared_residual(layer, v) > allowed) open.push_back(v);
      };
      for (const std::int32_t v : solver.nodes()) look_at(v, !solver.converged());
      for (const std::int32_t v : solver.rim()) look_at(v, true);
      solver.release(mark_);
    }
    std::sort(open.begin(), open.end());
    open.erase(std::unique(open.begin(), open.end()), open.end());
  }
}

void Equilibrium::cluster_seeds(const TriangleMesh& mesh, const std::vector<std::int32_t>& seeds,
                                double reach) {
  // Seeds within reach of each other belong together: patches must not share an element. Where
  // there are many, telling them apart costs more than it saves.
  constexpr std::size_t many = 1000;
  patch_count_ = 0;
  std::vector<char> taken(seeds.size(), 0);
  std::vector<std::size_t> cluster;
  for (std::size_t first = 0; first < seeds.size(); ++first) {
    if (taken[first]) continue;
    if (patches_.size() == patch_count_) patches_.emplace_back();
    Patch& patch = patches_[patch_count_++];
    patch.seeds.clear();
    if (seeds.size() > many) {
      patch.seeds = seeds;
      return;
    }
    cluster.assign(1, first);
    taken[first] = 1;
    for (std::size_t i = 0; i < cluster.size(); ++i) {
      const Vec3& p = mesh.position(seeds[cluster[i]]);
      patch.seeds.push_back(seeds[cluster[i]]);
      for (std::size_t j = first + 1; j < seeds.size(); ++j) {
        if (taken[j] || (mesh.position(seeds[j]) - p).squaredNorm() > reach * reach) continue;
        taken[j] = 1;
        cluster.push_back(j);
      }
    }
  }
}

void Equilibrium::apply(StressField& field, const LayerState& layer, Patch& patch) {
  const PatchSolver& solver = patch.solver;
  const std::int32_t active = solver.active();
  patch.displacements.resize(active);
  for (std::int32_t i = 0; i < active; ++i) {
    const Vec3 d = solver.displacement(layer, i);
    patch.displacements[i].v = Vec4d::Lanes{d.x(), d.y(), d.z(), 0};
    field.displacements()[solver.nodes()[i]].v += patch.displacements[i].v;
  }
  // A face belongs to the first of its nodes.
  const auto moved = [&](std::int32_t v) { return mark_[v] >= 0 && mark_[v] < active; };
  for (std::int32_t i = 0; i < active; ++i) {
    layer.mesh.for_each_outgoing(solver.nodes()[i], [&](std::int32_t h) {
      const Triangle& corners = layer.mesh.triangle(h / 3);
      Vec4d d[3];
      for (int c = 0; c < 3; ++c) {
        if (!moved(corners[c])) continue;
        if (mark_[corners[c]] < i) return;
        d[c] = patch.displacements[mark_[corners[c]]];
      }
      field.displace(h / 3, corners, d[0], d[1], d[2], drift_);
    });
  }
}

}  // namespace craze
