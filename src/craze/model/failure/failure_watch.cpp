#include "craze/model/failure/failure_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "craze/base/parallel.h"
#include "craze/model/failure/direction_bias.h"
#include "craze/model/failure/separation_tensor.h"
#include "craze/model/screening.h"

namespace craze {

namespace {

// A node that could not open on a plane is tried again when the plane has turned this much.
constexpr double arrest_cosine = 0.98;
// Keeps v⁺ over the threshold finite where the surface has no toughness at all.
constexpr double least_scale = 1e-100;
// In resistance_.
constexpr double unknown = -1;
// A node is looked at again when its v⁺ may have come this part of the way to the threshold.
constexpr double unwatched_part = 0.35;
// Edges that a crack may reach beyond the nodes it changes, and a look beyond its own length.
constexpr double edges_of_influence = 3;

double longest_edge(const TriangleMesh& mesh) {
  double squared = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h)
    squared = std::max(squared, mesh.way(mesh.from(h), mesh.to(h)).squaredNorm());
  return std::sqrt(squared);
}

}  // namespace

FailureWatch::FailureWatch(const SimulationParameters& parameters)
    : alpha_(parameters.material.alpha),
      bias_(parameters.material.bias),
      lookahead_(parameters.material.lookahead),
      criterion_(parameters.material, process_zone(parameters.material, parameters.layer)) {}

void FailureWatch::look_at(const Scene& scene, std::vector<std::int32_t>& nodes,
                           const Threads& threads) {
  failing_.resize(scene.mesh.vertex_count());
  resistance_.resize(scene.mesh.vertex_count(), unknown);
  if (!scene.fields.healed.empty()) scars_.resize(scene.mesh.vertex_count());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  parallel_for(threads, nodes.size(), 128, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      failing_[nodes[i]] = evaluate(scene, nodes[i], residuals_.count(nodes[i]) > 0);
    }
  });
  const double load = scene.loading.load();
  for (const std::int32_t v : nodes) {
    enter(scene, v);
    // A tip that does not fail has stopped: its residual is spent.
    if (!(failing_[v].measure * load >= 1)) residuals_.erase(v);
  }
}

void FailureWatch::foresee(const Scene& scene, double least_measure, const Threads& threads) {
  if (influence_ < 0) {
    influence_ = std::max(criterion_.process_zone(), lookahead_) +
                 edges_of_influence * longest_edge(scene.mesh);
  }
  // Otherwise the first crack of the step would leave next to nothing of it.
  if (influence_ > scene.relaxation.independence_distance()) return;
  // A step opens so many cracks and no more, however many nodes of a large mesh may crack.
  const std::size_t few = 16, most = asked_ + asked_ / 4 + few;
  asked_ = 0;
  foreseen_.begin(queue_.first(least_measure, most));
  std::vector<ForeseenFailure>& all = foreseen_.all();
  parallel_for(threads, all.size(), 4, [&](std::size_t begin, std::size_t end) {
    StressAhead stress_ahead;
    for (std::size_t i = begin; i < end; ++i) {
      const std::int32_t v = all[i].node;
      Failure& failure = all[i].failure;
      failure = is_exact(v) ? failing_[v] : evaluate(scene, v, true);
      if (!(failure.measure >= least_measure)) continue;
      all[i].plane = plane_of(scene, v, failure.normal, stress_ahead);
    }
  });
}

std::int32_t FailureWatch::next(const Scene& scene) {
  std::int32_t last = -1;
  while (!queue_.empty()) {
    const std::int32_t v = queue_.top();
    if (v != last) ++asked_;
    if (is_exact(v)) return v;
    last = v;
    const ForeseenFailure* foreseen = foreseen_.find(v);
    failing_[v] = foreseen ? foreseen->failure : evaluate(scene, v, true);
    enter(scene, v);
  }
  return -1;
}

bool FailureWatch::can_any_fail() const {
  for (std::size_t v = 0; v < failing_.size(); ++v) {
    if (failing_[v].measure > 0 && arrested_.count(static_cast<std::int32_t>(v)) == 0) return true;
  }
  return false;
}

void FailureWatch::enter(const Scene& scene, std::int32_t v) {
  Failure& failure = failing_[v];
  if (failure.shield >= 0) {
    shielded_[failure.shield].push_back(v);
    // Looked at again when that tip is gone, whatever its stress does.
    scene.relaxation.allow_drift(v, std::numeric_limits<double>::infinity());
    queue_.remove(v);
    return;
  }
  const double load = scene.loading.load(), highest = scene.loading.highest_load();
  double unwatched = 0;
  if (!failure.exact && load > 0) {
    const double room = 1 / load - failure.measure;
    unwatched = unwatched_part * std::max(0.0, room);
  }
  // v⁺ changes by no more than the forces do, times the factor on ς.
  const double force_per_measure = failure.threshold / std::max(least_scale, failure.weight);
  const double granted = scene.relaxation.allow_drift(v, unwatched * force_per_measure);
  double key = failure.measure;
  if (!failure.exact && force_per_measure > 0) key += granted / force_per_measure;
  queue_.set(v, key * highest > 1 ? key : 0);
}

Sym3 FailureWatch::biased(const Scene& scene, std::int32_t v, const Sym3& separation) const {
  if (scene.fields.preferred.empty()) return separation;
  const std::int32_t f = TriangleMesh::face_of(scene.mesh.first_halfedge(v));
  return bias_direction(separation, scene.fields.preferred[scene.mesh.source_face(f)], bias_);
}

Failure FailureWatch::evaluate(const Scene& scene, std::int32_t v, bool exact) {
  const double scale = resistance(scene, v);
  const double load = scene.loading.load();
  const double weight = mean_factor(scene.mesh, scene.fields.separation_scale, v);
  const Sym3 tensor =
      biased(scene, v, weight * separation_tensor(scene.mesh, scene.field, v).tensor);
  const auto residual = residuals_.find(v);
  // A tip with a residual fails with its help now, or without it later.
  Failure failure;
  if (residual != residuals_.end() && load > 0) {
    Sym3 driven = tensor;
    driven += (1 / load) * residual->second;
    failure = failure_of(scene, v, driven, scale, true);
    if (!(failure.measure * load > 1)) failure = {};
  }
  if (failure.measure == 0) failure = failure_of(scene, v, tensor, scale, exact);
  failure.weight *= weight;
  const auto arrested = arrested_.find(v);
  if (arrested != arrested_.end() &&
      std::abs(arrested->second.dot(failure.normal)) > arrest_cosine) {
    failure.measure = 0;
    failure.exact = true;
  }
  return failure;
}

Failure FailureWatch::failure_of(const Scene& scene, std::int32_t v, const Sym3& separation,
                                 double scale, bool exact) {
  Failure failure;
  Eigenpair pair;
  if (scene.fields.healed.empty()) {
    pair = largest_eigenpair(separation);
  } else {
    const WeakPlane weak = scene.fields.healed.weakest_plane(weakness(scene, v), separation);
    pair = weak.plane;
    scale *= weak.strength;
    failure.weight = weak.sensitivity;
  }
  failure.normal = pair.vector;
  failure.threshold = criterion_.least_threshold(scene.mesh, v, pair.vector, scale);
  if (!(failure.threshold > 0)) return failure;
  failure.measure = std::max(0.0, pair.value) / failure.threshold;
  if (!exact) return failure;
  failure.exact = true;
  if (!(pair.value > 0)) return failure;
  failure.threshold = criterion_.threshold(scene.mesh, scene.field, v, pair, scale,
                                           failure.threshold, failure.shield);
  failure.measure = pair.value / failure.threshold;
  return failure;
}

CrackPlane FailureWatch::crack_plane(const Scene& scene, std::int32_t v) {
  const ForeseenFailure* foreseen = foreseen_.find(v);
  if (foreseen && foreseen->plane) return *foreseen->plane;
  return plane_of(scene, v, failing_[v].normal, stress_ahead_);
}

CrackPlane FailureWatch::plane_of(const Scene& scene, std::int32_t v, const Vec3& normal,
                                  StressAhead& stress_ahead) {
  if (!(lookahead_ > 0) || !is_crack_tip(scene.mesh, v)) return {normal, false};
  const double width = node_width(scene.mesh, v, normal);
  // A mean over less than the tip's star tells less than ς does.
  if (lookahead_ < width) return {normal, false};
  const Sym3 stress = stress_ahead.mean(scene.mesh, scene.field, v, lookahead_);
  // The v⁺ of a tension is node_width() times it.
  Sym3 driven =
      biased(scene, v, mean_factor(scene.mesh, scene.fields.separation_scale, v) * width * stress);
  const auto residual = residuals_.find(v);
  if (residual != residuals_.end()) driven += (1 / scene.loading.load()) * residual->second;
  const Eigenpair plane = scene.fields.healed.empty()
                              ? largest_eigenpair(driven)
                              : scene.fields.healed.weakest_plane(weakness(scene, v), driven).plane;
  if (!(plane.value > 0)) return {normal, false};
  return {plane.vector, true};
}

double FailureWatch::resistance(const Scene& scene, std::int32_t v) {
  double& factor = resistance_[v];
  if (factor == unknown) {
    factor = std::max(least_scale, mean_factor(scene.mesh, scene.fields.toughness_scale, v));
  }
  return factor;
}

const Mat3& FailureWatch::weakness(const Scene& scene, std::int32_t v) {
  Scar& scar = scars_[v];
  const Vec3& position = scene.mesh.position(v);
  if (scar.weakness.isZero(0) || scar.position != position) {
    scar = {position, scene.fields.healed.weakness(position)};
  }
  return scar.weakness;
}

Sym3 FailureWatch::residual(std::int32_t v) const {
  const auto found = residuals_.find(v);
  return found == residuals_.end() ? Sym3{} : found->second;
}

void FailureWatch::could_not_open(std::int32_t v) {
  queue_.remove(v);
  residuals_.erase(v);
  arrested_[v] = failing_[v].normal;
}

void FailureWatch::opened(const Scene& scene, std::int32_t v, const Vec3& normal,
                          const CrackOutcome& outcome, std::vector<std::int32_t>& changed) {
  // [IO06 Eq. 8] The residual v* = v⁺ − τ drives the new tips on.
  const Failure failure = failing_[v];
  const double excess =
      std::max(0.0, failure.measure * scene.loading.load() - 1) * failure.threshold;
  foreseen_.opened(scene.mesh, v, outcome.changed_nodes, influence_);
  queue_.remove(v);
  residuals_.erase(v);
  for (const std::int32_t tip : outcome.tips) {
    Sym3 residual;
    add_outer(residual, alpha_ * excess, normal);
    residuals_[tip] = residual;
    criterion_.tip_advanced(scene.mesh, v, tip);
  }
  for (const std::int32_t n : outcome.changed_nodes) {
    changed.push_back(n);
    if (n < static_cast<std::int32_t>(resistance_.size())) resistance_[n] = unknown;
    arrested_.erase(n);
    queue_.remove(n);
    if (!criterion_.node_changed(scene.mesh, n)) continue;
    const auto shielded = shielded_.find(n);
    if (shielded == shielded_.end()) continue;
    changed.insert(changed.end(), shielded->second.begin(), shielded->second.end());
    shielded_.erase(shielded);
  }
}

void FailureWatch::renumber(const std::vector<std::int32_t>& now) {
  const auto residuals = std::exchange(residuals_, {});
  for (const auto& [v, residual] : residuals) residuals_[new_number(now, v)] = residual;
  queue_ = {};
  failing_ = std::vector<Failure>();
  resistance_ = std::vector<double>();
  scars_ = std::vector<Scar>();
}

void FailureWatch::shrink_to_fit() {
  queue_.shrink_to_fit();
  failing_.shrink_to_fit();
  resistance_.shrink_to_fit();
  scars_.shrink_to_fit();
}

}  // namespace craze
