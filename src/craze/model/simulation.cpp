#include "craze/model/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "craze/error.h"
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

void check_sizes(const SimulationFields& fields, const TriangleMesh& mesh) {
  const auto faces = static_cast<std::size_t>(mesh.face_count());
  const auto vertices = static_cast<std::size_t>(mesh.vertex_count());
  check_size(fields.stress.size(), faces, "stress");
  check_size(fields.growth.size(), faces, "growth");
  check_size(fields.toughness_scale.size(), faces, "toughness scale");
  check_size(fields.separation_scale.size(), faces, "separation scale");
  check_size(fields.adhesion_scale.size(), faces, "adhesion scale");
  check_size(fields.preferred.size(), faces, "preferred directions");
  check_size(fields.fixed.size(), vertices, "fixed");
  check_size(fields.pinned.size(), vertices, "pinned");
}

/// The mesh under σ₀, with its held and pinned nodes. Throws Error(request) where a field's size is
/// wrong.
CrackedSheet stressed_sheet(TriangleMesh mesh, const SimulationFields& fields, Engine engine) {
  check_sizes(fields, mesh);
  StressField field(mesh, engine_singular_value_cap(mesh, engine));
  for (std::size_t v = 0; v < fields.fixed.size(); ++v) {
    if (!fields.fixed[v]) continue;
    field.hold(static_cast<std::int32_t>(v));
    mesh.pin(static_cast<std::int32_t>(v));
  }
  for (std::size_t v = 0; v < fields.pinned.size(); ++v) {
    if (fields.pinned[v]) mesh.pin(static_cast<std::int32_t>(v));
  }
  for (std::size_t f = 0; f < fields.stress.size(); ++f) {
    field.add_stress(mesh, static_cast<std::int32_t>(f), fields.stress[f]);
  }
  if (!fields.adhesion_scale.empty()) field.set_adhesion(mesh, fields.adhesion_scale);
  field.update_forces(mesh);
  return {std::move(mesh), std::move(field)};
}

/// Area mean of tr σ / 2, force/length.
double mean_tension(const CrackedSheet& sheet) {
  double tension = 0, area = 0;
  for (std::int32_t f = 0; f < sheet.mesh().face_count(); ++f) {
    const Sym3 sigma = sheet.field().stress(sheet.mesh(), f);
    tension += 0.5 * (sigma.xx + sigma.yy + sigma.zz) * sheet.mesh().area(f);
    area += sheet.mesh().area(f);
  }
  return area > 0 ? tension / area : 0;
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
      // 1. Initialize the stress field according to heuristics and optionally evolve it.
      sheet_(stressed_sheet(std::move(mesh), fields_, running_engine(parameters_))),
      loading_(make_loading(parameters_, {mean_tension(sheet_), std::move(fields_.growth)})),
      relaxation_(make_relaxation(sheet_.mesh(), sheet_.field(), parameters_)),
      watch_(parameters_) {
  // 2. Compute the failure criteria for each node and store them in a priority queue.
  for (std::int32_t v = 0; v < sheet_.mesh().vertex_count(); ++v) changed_.push_back(v);
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
    context.report({"crack", -1, events_, mesh().face_count(), load()});
  }
  relaxation_->release_memory();
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
  if (loading_->reached_max_load()) return stop(StopReason::max_load);
  const std::int32_t next = watch_.next(scene());
  if (next >= 0 && fails_now(next)) return true;
  // Nodes that would fail above the highest load are not queued.
  double needed = std::numeric_limits<double>::infinity();
  if (next >= 0) {
    needed = 1 / watch_.measure(next);
  } else if (watch_.can_any_fail()) {
    needed = std::nextafter(loading_->highest_load(), needed);
  }
  if (loading_->advance(needed, relaxation_->at_rest())) return true;
  return stop(loading_->reached_max_load() ? StopReason::max_load : StopReason::equilibrium);
}

bool Simulation::fails_now(std::int32_t v) const {
  // advance() raises the load to 1 / measure, rounded.
  constexpr double rounding = 1e-12;
  return watch_.measure(v) * loading_->load_of_step() >= 1 - rounding;
}

void Simulation::crack_mesh() {
  const Stopwatch watch(times_.crack);
  // Nodes that fail far from each other do not interact: they crack in one step. A node too close
  // to one that is already taken keeps its place in the queue.
  const double apart = relaxation_->independence_distance();
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
    const Vec3 position = mesh().position(v);
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
  open_crack(sheet_, v, normal, rules, static_cast<std::int32_t>(segments()), outcome_);
  if (outcome_.empty()) {
    watch_.could_not_open(v);
    return false;
  }
  const Vec3 start = mesh().position(v);  // a copy: the mesh's own moves as it grows
  run_on(start, normal, rules);
  for (const CrackSegment& s : outcome_.segments) {
    opened_.push_back({s, loading_->time(), static_cast<std::int32_t>(events_)});
  }
  ++events_;
  watch_.opened(scene(), v, normal, outcome_, changed_);
  relaxation_->mesh_changed(mesh(), outcome_);
  return true;
}

void Simulation::run_on(const Vec3& start, const Vec3& normal, const CrackRules& rules) {
  const double length = relaxation_->stride();
  const auto may_run = [&](std::int32_t tip) {
    return (mesh().position(tip) - start).norm() < length &&
           std::isfinite(mean_factor(mesh(), fields_.toughness_scale, tip));
  };
  const std::vector<std::int32_t> tips = outcome_.tips;
  for (std::int32_t tip : tips) {
    while (may_run(tip)) {
      const auto label = static_cast<std::int32_t>(opened_.size() + outcome_.segments.size());
      open_crack(sheet_, tip, normal, rules, label, step_);
      if (step_.empty()) break;
      outcome_.append(step_, tip);
      if (step_.tips.empty()) break;
      tip = step_.tips.front();
    }
  }
}

void Simulation::evolve(const Context& context) {
  const Stopwatch watch(times_.relax);
  // 3b.i Relaxation.
  relaxation_->relax(sheet_.field(), mesh(), loading_->load(), context.threads, changed_);
  // 3b.ii Shrinkage tension and curvature biasing.
  if (!loading_->grow(sheet_.field(), mesh())) return;
  for (std::int32_t v = 0; v < mesh().vertex_count(); ++v) changed_.push_back(v);
}

void Simulation::update_failure_criteria(const Context& context) {
  const Stopwatch watch(times_.separation);
  watch_.look_at(scene(), changed_, context.threads);
  changed_.clear();
}

Sym3 Simulation::separation(std::int32_t v) const {
  return mean_factor(mesh(), fields_.separation_scale, v) *
         separation_tensor(mesh(), field(), v).tensor;
}

std::vector<double> Simulation::crack_times() const {
  std::vector<double> times;
  times.reserve(opened_.size());
  for (const OpenedSegment& s : opened_) times.push_back(s.time);
  return times;
}

}  // namespace craze
