#include "craze/model/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "craze/base/error.h"
#include "craze/model/failure/separation_tensor.h"
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
      watch_(parameters_) {
  const auto faces = static_cast<std::size_t>(mesh_.face_count());
  check_size(fields_.stress.size(), faces, "stress");
  check_size(fields_.growth.size(), faces, "growth");
  check_size(fields_.toughness_scale.size(), faces, "toughness scale");
  check_size(fields_.separation_scale.size(), faces, "separation scale");
  check_size(fields_.adhesion_scale.size(), faces, "adhesion scale");
  check_size(fields_.preferred.size(), faces, "preferred directions");
  check_size(fields_.fixed.size(), static_cast<std::size_t>(mesh_.vertex_count()), "fixed");
  check_size(fields_.pinned.size(), static_cast<std::size_t>(mesh_.vertex_count()), "pinned");
  for (const std::vector<char>* marks : {&fields_.fixed, &fields_.pinned}) {
    for (std::size_t v = 0; v < marks->size(); ++v) {
      if ((*marks)[v]) mesh_.pin(static_cast<std::int32_t>(v));
    }
  }

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
  evolution_ = make_evolution(mesh_, field_, parameters_,
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
  evolution_->release_memory();
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
  const std::int32_t next = watch_.next(scene());
  if (next >= 0 && fails_now(next)) return true;
  // Nodes that would fail above the highest load are not queued.
  double needed = std::numeric_limits<double>::infinity();
  if (next >= 0) {
    needed = 1 / watch_.measure(next);
  } else if (watch_.can_any_fail()) {
    needed = std::nextafter(evolution_->highest_load(), needed);
  }
  if (evolution_->advance(needed)) return true;
  return stop(evolution_->reached_max_load() ? StopReason::max_load : StopReason::equilibrium);
}

bool Simulation::fails_now(std::int32_t v) const {
  // advance() raises the load to 1 / measure, rounded.
  constexpr double rounding = 1e-12;
  return watch_.measure(v) * evolution_->load_of_step() >= 1 - rounding;
}

void Simulation::crack_mesh() {
  const Stopwatch watch(times_.crack);
  // Nodes that fail far from each other do not interact: they crack in one step. A node too close
  // to one that is already taken keeps its place in the queue.
  const double apart = evolution_->independence_distance();
  const std::int64_t most =
      parameters_.engine == Engine::euler ? parameters_.evolution.cracks_per_step : largest_batch;
  std::vector<Vec3> taken;
  std::vector<std::int32_t> waiting;
  std::int64_t cracked = 0;
  while (cracked < most) {
    if (const std::int64_t limit = parameters_.evolution.max_cracks;
        limit > 0 && events_ >= limit) {
      break;
    }
    const std::int32_t v = watch_.next(scene());
    if (v < 0 || !fails_now(v)) break;
    const Vec3 position = mesh_.position(v);
    const bool independent = std::all_of(taken.begin(), taken.end(), [&](const Vec3& p) {
      return (p - position).squaredNorm() >= apart * apart;
    });
    if (!independent) {
      if (apart == std::numeric_limits<double>::infinity()) break;
      waiting.push_back(v);
      watch_.set_aside(v);
      taken.push_back(position);
      continue;
    }
    if (crack_at(v)) {
      ++cracked;
      taken.push_back(position);
    }
  }
  for (const std::int32_t v : waiting) watch_.take_back(v);
}

bool Simulation::crack_at(std::int32_t v) {
  constexpr double degree = std::numbers::pi / 180;
  const auto [normal, ahead_only] = watch_.crack_plane(scene(), v);
  const double back_angle = ahead_only ? 90 : parameters_.crack.back_angle;
  const CrackRules rules{parameters_.crack.snap_angle * degree, back_angle * degree,
                         parameters_.crack.near_vertex};
  open_crack(mesh_, field_, v, normal, rules, static_cast<std::int32_t>(segments()), outcome_);
  if (outcome_.empty()) {
    watch_.could_not_open(v);
    return false;
  }
  const Vec3 start = mesh_.position(v);  // a copy: the mesh's own moves as it grows
  run_on(start, normal, rules);
  for (const CrackSegment& s : outcome_.segments) {
    segments_.push_back({s, evolution_->time(), static_cast<std::int32_t>(events_)});
  }
  ++events_;
  watch_.opened(scene(), v, normal, outcome_, changed_);
  hold_new_nodes();
  evolution_->mesh_changed(mesh_, outcome_);
  return true;
}

void Simulation::run_on(const Vec3& start, const Vec3& normal, const CrackRules& rules) {
  const double length = evolution_->stride();
  const auto may_run = [&](std::int32_t tip) {
    return (mesh_.position(tip) - start).norm() < length &&
           std::isfinite(mean_factor(mesh_, fields_.toughness_scale, tip));
  };
  const std::vector<std::int32_t> tips = outcome_.tips;
  for (std::int32_t tip : tips) {
    while (may_run(tip)) {
      const auto label = static_cast<std::int32_t>(segments_.size() + outcome_.segments.size());
      open_crack(mesh_, field_, tip, normal, rules, label, step_);
      if (step_.empty()) break;
      outcome_.append(step_, tip);
      if (step_.tips.empty()) break;
      tip = step_.tips.front();
    }
  }
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
  watch_.look_at(scene(), changed_, context.threads);
  changed_.clear();
}

Sym3 Simulation::separation(std::int32_t v) const {
  return mean_factor(mesh_, fields_.separation_scale, v) *
         separation_tensor(mesh_, field_, v).tensor;
}

std::vector<double> Simulation::crack_times() const {
  std::vector<double> times;
  times.reserve(segments_.size());
  for (const Segment& s : segments_) times.push_back(s.time);
  return times;
}

}  // namespace craze
