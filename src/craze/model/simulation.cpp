#include "craze/model/simulation.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <numbers>
#include <string>

#include "craze/base/error.h"
#include "craze/base/parallel.h"
#include "craze/model/screening.h"

namespace craze {

namespace {

class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Nodes cracked in one step at most.
constexpr std::int64_t largest_batch = 64;
// A node that could not open on a plane is tried again when the plane has turned this much.
constexpr double arrest_cosine = 0.98;
// Keeps v⁺ over the threshold finite where the surface has no toughness at all.
constexpr double least_scale = 1e-100;

void check_size(std::size_t size, std::size_t expected, const char* name) {
  if (size != 0 && size != expected) {
    throw Error(ErrorKind::request, "wrong number of values", name,
                std::to_string(size) + " given, " + std::to_string(expected) + " needed");
  }
}

}  // namespace

const char* to_string(StopReason reason) {
  switch (reason) {
    case StopReason::equilibrium:
      return "equilibrium";
    case StopReason::max_load:
      return "max_load";
    case StopReason::max_cracks:
      return "max_cracks";
    case StopReason::cancelled:
      return "cancelled";
  }
  return "";
}

Simulation::Simulation(TriangleMesh mesh, SimulationFields fields,
                       const SimulationParameters& parameters, const Context& context)
    : parameters_(resolve_lengths(parameters, bounding_diagonal(mesh.positions()))),
      fields_(std::move(fields)),
      mesh_(std::move(mesh)),
      field_(mesh_, engine_singular_value_cap(mesh_, running_engine(parameters_))),
      criterion_(parameters_.material, process_zone(parameters_.material, parameters_.layer)) {
  const auto faces = static_cast<std::size_t>(mesh_.face_count());
  check_size(fields_.stress.size(), faces, "stress");
  check_size(fields_.growth.size(), faces, "growth");
  check_size(fields_.toughness_scale.size(), faces, "toughness scale");
  check_size(fields_.separation_scale.size(), faces, "separation scale");
  check_size(fields_.adhesion_scale.size(), faces, "adhesion scale");
  check_size(fields_.preferred.size(), faces, "preferred directions");
  check_size(fields_.fixed.size(), static_cast<std::size_t>(mesh_.vertex_count()), "fixed");

  // 1. Initialize the stress field according to heuristics and optionally evolve it.
  double tension = 0, area = 0;
  for (std::int32_t f = 0; f < mesh_.face_count() && !fields_.stress.empty(); ++f) {
    field_.add_stress(mesh_, f, fields_.stress[f]);
    const Sym3 sigma = field_.stress(mesh_, f);
    tension += 0.5 * (sigma.xx + sigma.yy + sigma.zz) * mesh_.area(f);
    area += mesh_.area(f);
  }
  if (!fields_.adhesion_scale.empty()) field_.set_adhesion(mesh_, fields_.adhesion_scale);
  field_.update_forces(mesh_);
  evolution_ = make_evolution(mesh_, parameters_,
                              {area > 0 ? tension / area : 0, &fields_.growth, fields_.fixed});

  // 2. Compute the failure criteria for each node and store them in a priority queue.
  for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) changed_.push_back(v);
  update_failure_criteria(context);
}

StopReason Simulation::run(const Context& context) {
  if (running_engine(parameters_) == Engine::quasistatic && events_ == 0) {
    evolve(context);
    update_failure_criteria(context);
  }
  // 3. While failure can occur and we want to continue:
  while (can_continue(context)) {
    // 3a. Crack the mesh at the node associated with the top of the priority queue.
    crack_mesh();
    // 3b. Evolve the stress field.
    evolve(context);
    // 3c. Update the mesh information and priority queue.
    update_failure_criteria(context);
    context.report({"crack", -1, events_, mesh_.face_count(), load()});
  }
  // 4. For display: post/ and render/.
  return stop_;
}

bool Simulation::can_continue(const Context& context) {
  const auto stop = [&](StopReason reason) {
    stop_ = reason;
    return false;
  };
  const std::int64_t limit = parameters_.evolution.max_cracks;
  if (context.is_cancelled()) return stop(StopReason::cancelled);
  if (limit > 0 && events_ >= limit) return stop(StopReason::max_cracks);
  if (evolution_->reached_max_load()) return stop(StopReason::max_load);
  if (!queue_.empty() && fails_now(queue_.top())) return true;
  const double needed =
      queue_.empty() ? std::numeric_limits<double>::infinity() : 1 / queue_.measure(queue_.top());
  if (evolution_->advance(needed)) return true;
  return stop(evolution_->reached_max_load() ? StopReason::max_load : StopReason::equilibrium);
}

bool Simulation::fails_now(std::int32_t v) const {
  // advance() raises the load to 1 / measure, rounded.
  constexpr double rounding = 1e-12;
  return queue_.measure(v) * evolution_->load() >= 1 - rounding;
}

void Simulation::crack_mesh() {
  const Stopwatch watch(times_.crack);
  // Nodes that fail far from each other do not interact: they crack in one step. A node too close
  // to one that is already taken keeps its place in the queue, and its own surroundings with it.
  const double apart = evolution_->independence_distance();
  const std::int64_t most =
      parameters_.engine == Engine::euler ? parameters_.evolution.cracks_per_step : largest_batch;
  std::vector<Vec3> taken;
  std::vector<std::pair<std::int32_t, double>> waiting;
  std::int64_t cracked = 0;
  while (cracked < most && !queue_.empty() && fails_now(queue_.top())) {
    if (const std::int64_t limit = parameters_.evolution.max_cracks;
        limit > 0 && events_ >= limit) {
      break;
    }
    const std::int32_t v = queue_.top();
    const Vec3 position = mesh_.position(v);
    const bool independent = std::all_of(taken.begin(), taken.end(), [&](const Vec3& p) {
      return (p - position).squaredNorm() >= apart * apart;
    });
    if (!independent) {
      if (apart == std::numeric_limits<double>::infinity()) break;
      waiting.emplace_back(v, queue_.measure(v));
      queue_.remove(v);
      taken.push_back(position);
      continue;
    }
    if (crack_at(v)) {
      ++cracked;
      taken.push_back(position);
    }
  }
  for (const auto& [v, measure] : waiting) queue_.set(v, measure);
}

bool Simulation::crack_at(std::int32_t v) {
  const CrackRules rules{parameters_.crack.snap_angle * std::numbers::pi / 180,
                         parameters_.crack.back_angle * std::numbers::pi / 180};
  const Failure failure = failing_[v];
  open_crack(mesh_, field_, v, failure.normal, rules, static_cast<std::int32_t>(segments()),
             outcome_);
  queue_.remove(v);
  residuals_.erase(v);
  if (outcome_.empty()) {
    arrested_[v] = failure.normal;
    return false;
  }
  for (const CrackSegment& s : outcome_.segments) {
    segments_.push_back({s, evolution_->time(), static_cast<std::int32_t>(events_)});
  }
  ++events_;

  // [IO06 Eq. 8] The residual v* = v⁺ − τ drives the new tips on.
  const double excess = (failure.measure * evolution_->load() - 1) * failure.threshold;
  for (const std::int32_t tip : outcome_.tips) {
    Sym3 residual;
    add_outer(residual, parameters_.material.alpha * excess, failure.normal);
    residuals_[tip] = residual;
    criterion_.tip_advanced(mesh_, v, tip);
  }
  for (const std::int32_t n : outcome_.changed_nodes) {
    changed_.push_back(n);
    arrested_.erase(n);
    queue_.remove(n);
    criterion_.node_changed(mesh_, n);
  }
  hold_new_nodes();
  evolution_->mesh_changed(mesh_, outcome_);
  return true;
}

void Simulation::hold_new_nodes() {
  // New vertices on a held border, and copies of held vertices, are held.
  std::vector<char>& fixed = evolution_->fixed();
  if (fixed.empty()) return;
  const auto old = static_cast<std::int32_t>(fixed.size());
  fixed.resize(mesh_.vertex_count(), 0);
  for (std::int32_t n = old; n < mesh_.vertex_count(); ++n) {
    const std::int32_t root = mesh_.root(n), h = mesh_.first_halfedge(n);
    if (root != n) {
      fixed[n] = fixed[root];
    } else if (mesh_.is_open(h) && mesh_.crack_of(h) < 0) {
      fixed[n] = fixed[mesh_.to(h)];
    }
  }
}

void Simulation::evolve(const Context& context) {
  const Stopwatch watch(times_.relax);
  evolution_->evolve(field_, mesh_, context.threads, changed_);
}

void Simulation::update_failure_criteria(const Context& context) {
  const Stopwatch watch(times_.separation);
  failing_.resize(mesh_.vertex_count());
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  parallel_for(context.threads, changed_.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) evaluate(changed_[i]);
  });
  for (const std::int32_t v : changed_) {
    queue_.set(v, failing_[v].measure);
    // A tip that does not fail has stopped: its residual is spent.
    if (!fails_now(v)) residuals_.erase(v);
  }
  changed_.clear();
}

void Simulation::evaluate(std::int32_t v) {
  failing_[v] = {};
  const double scale = std::max(least_scale, scale_at(fields_.toughness_scale, v));
  const double highest = evolution_->highest_load(), load = evolution_->load();
  const double weight = scale_at(fields_.separation_scale, v);
  const SeparationTensor separation = separation_tensor(mesh_, field_, v);
  const auto residual = residuals_.find(v);
  const bool has_residual = residual != residuals_.end() && load > 0;
  if (!has_residual && weight * separation.bound * highest <= criterion_.least_threshold(scale)) {
    return;
  }
  Sym3 tensor = weight * separation.tensor;
  if (!fields_.preferred.empty()) {
    const std::int32_t f = mesh_.first_halfedge(v) / 3;
    tensor =
        bias_direction(tensor, fields_.preferred[mesh_.source_face(f)], parameters_.material.bias);
  }
  Failure failure;
  // A tip with a residual fails with its help now, or without it later.
  if (has_residual) {
    Sym3 driven = tensor;
    driven += (1 / load) * residual->second;
    failure = failure_of(v, driven, scale);
    if (!(failure.measure * load > 1)) failure.measure = 0;
  }
  if (failure.measure == 0) failure = failure_of(v, tensor, scale);
  if (!(failure.measure * highest > 1)) return;
  const auto arrested = arrested_.find(v);
  if (arrested != arrested_.end() &&
      std::abs(arrested->second.dot(failure.normal)) > arrest_cosine) {
    return;
  }
  failing_[v] = failure;
}

Simulation::Failure Simulation::failure_of(std::int32_t v, const Sym3& separation,
                                           double scale) const {
  const Eigenpair pair = largest_eigenpair(separation);
  if (!(pair.value > 0)) return {};
  const double threshold = criterion_.threshold(mesh_, field_, v, pair, scale);
  return {threshold > 0 ? pair.value / threshold : 0, threshold, pair.vector};
}

double Simulation::scale_at(const std::vector<double>& per_face, std::int32_t v) const {
  if (per_face.empty()) return 1;
  double sum = 0, count = 0;
  mesh_.for_each_outgoing(v, [&](std::int32_t h) {
    sum += per_face[mesh_.source_face(h / 3)];
    ++count;
  });
  return count > 0 ? sum / count : 1;
}

Sym3 Simulation::separation(std::int32_t v) const {
  return scale_at(fields_.separation_scale, v) * separation_tensor(mesh_, field_, v).tensor;
}

std::vector<double> Simulation::crack_times() const {
  std::vector<double> times;
  times.reserve(segments_.size());
  for (const Segment& s : segments_) times.push_back(s.time);
  return times;
}

}  // namespace craze
