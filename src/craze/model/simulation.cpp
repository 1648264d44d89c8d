#include "craze/model/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>

#include "craze/error.h"
#include "craze/mesh/bounding_diagonal.h"
#include "craze/model/failure/separation_tensor.h"
#include "craze/model/initial_state.h"
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

// Element updates after which a run in which nothing fails is given up: some minutes.
constexpr double most_idle_work = 3e10;
// What adding the growth to an element costs, in updates.
constexpr double growth_cost = 30;
// Measure times load of a node that fails: advance() raises the load to 1 / measure, rounded.
constexpr double least_failing = 1 - 1e-12;

/// Asks the context whether to stop, and reports, no more often than is of use.
class Heartbeat {
 public:
  Heartbeat(const Context& context, const Progress& progress)
      : context_(context), progress_(progress) {}

  bool stopped() const { return stopped_; }
  bool stops() {
    const auto now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) return stopped_;
    last_ = now;
    context_.report(progress_);
    return stopped_ = stopped_ || context_.is_cancelled();
  }

 private:
  using Clock = std::chrono::steady_clock;
  const Context& context_;
  Progress progress_;
  Clock::time_point last_ = Clock::now();
  bool stopped_ = false;
};

/// What the relaxation has to know: how far the stored field will be scaled.
SimulationParameters up_to(double highest_load, SimulationParameters parameters) {
  parameters.evolution.max_load = highest_load;
  return parameters;
}

/// Refuses before it starts what would take hours without a crack: too many steps in a round, or of
/// load.
void check_work(const Loading& loading, const Relaxation& relaxation) {
  constexpr double most_updates = 1e12;  // of elements: about an hour
  const double round = relaxation.work_of_a_round(), steps = loading.steps();
  if (round * steps <= most_updates) return;
  const auto fail = [&](const char* where, const char* why) {
    std::ostringstream updates;
    updates << round * steps;
    throw Error(ErrorKind::request, "too many steps", where,
                updates.str() + " updates of a triangle would take hours; " + why);
  };
  if (round > most_updates) {
    fail("evolution.relaxation_steps", "give fewer, or a smaller evolution.time_step");
  }
  fail("evolution.max_load", "give less, or more evolution.shrinkage");
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
    case StopReason::shattered:
      return "shattered";
    case StopReason::idle:
      return "idle";
    case StopReason::cancelled:
      return "cancelled";
  }
  return "";
}

Simulation::Simulation(TriangleMesh mesh, SimulationFields fields,
                       const SimulationParameters& parameters, const Context& context)
    : parameters_(
          checked(resolve_lengths(parameters, bounding_diagonal(mesh.positions(), mesh.period())))),
      fields_(std::move(fields)),
      // 1. Initialize the stress field according to heuristics and optionally evolve it.
      sheet_(stressed_sheet(std::move(mesh), fields_, running_engine(parameters_), context)),
      loading_(make_loading(parameters_, initial_load(sheet_, fields_, parameters_.material))),
      relaxation_(make_relaxation(sheet_.mesh(), sheet_.field(),
                                  up_to(loading_->highest_load(), parameters_))),
      watch_(parameters_),
      unmeasured_(sheet_.mesh().vertex_count()),
      // Twice the edges of the input: when as many pieces of crack are open, few are left whole.
      most_segments_(3 * std::int64_t{sheet_.mesh().face_count()} + 1000) {
  check_work(*loading_, *relaxation_);
  // The sheet and the loading have these now. (`= {}` would keep their room.)
  fields_.stress = std::vector<Sym3>();
  fields_.adhesion_scale = std::vector<double>();
  fields_.fixed = std::vector<char>();
  fields_.pinned = std::vector<char>();
}

bool Simulation::measure_all_nodes(const Context& context) {
  constexpr std::int32_t slice = 1 << 14;
  const std::int32_t nodes = mesh().vertex_count();
  while (unmeasured_ > 0) {
    if (context.is_cancelled()) return false;
    const std::int32_t begin = nodes - unmeasured_, end = begin + std::min(unmeasured_, slice);
    for (std::int32_t v = begin; v < end; ++v) changed_.push_back(v);
    update_failure_criteria(context);
    unmeasured_ = nodes - end;
    context.report({"prepare", static_cast<double>(end) / nodes, 0, mesh().face_count()});
  }
  return true;
}

StopReason Simulation::run(const Context& context, const OnOpened& on_opened) {
  // 2. Compute the failure criteria for each node and store them in a priority queue.
  if (!measure_all_nodes(context)) return stop_ = StopReason::cancelled;
  const bool starts = running_engine(parameters_) == Engine::quasistatic && events_ == 0;
  if (starts || interrupted_) {
    evolve(context);
    update_failure_criteria(context);
  }
  // 3. While failure can occur and we want to continue:
  while (can_continue(context)) {
    // 3a. Crack the mesh at the node associated with the top of the priority queue.
    const std::size_t known = opened_.size();
    crack_mesh(context.threads);
    if (on_opened) tell(on_opened, known);
    // 3b. Evolve the stress field.
    evolve(context);
    // 3c. Update the mesh information and priority queue.
    update_failure_criteria(context);
    context.report({"crack", -1, events_, mesh().face_count(), load()});
  }
  relaxation_->release_memory();
  sheet_.shrink_to_fit();
  watch_.shrink_to_fit();
  check_state();
  // 4. For display: post/ and render/.
  return stop_;
}

double Simulation::idle_work() const {
  return static_cast<double>(element_updates() - updates_at_crack_) + growth_cost * idle_growth_;
}

bool Simulation::can_continue(const Context& context) {
  const auto stop = [&](StopReason reason) {
    stop_ = reason;
    return false;
  };
  const std::int64_t limit = parameters_.evolution.max_cracks;
  if (interrupted_ || context.is_cancelled()) return stop(StopReason::cancelled);
  if (limit > 0 && events_ >= limit) return stop(StopReason::max_cracks);
  if (segments() >= most_segments_) return stop(StopReason::shattered);
  if (idle_work() > most_idle_work) return stop(StopReason::idle);
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
  return !(watch_.measure(v) * loading_->load_of_step() < least_failing);
}

void Simulation::crack_mesh(const Threads& threads) {
  const Stopwatch watch(times_.crack);
  // Nodes that fail far from each other do not interact: they crack in one step. A node too close
  // to one that is already taken keeps its place in the queue.
  const double apart = relaxation_->independence_distance();
  const std::int64_t most = relaxation_->most_cracks_at_once();
  if (most > 1 && threads.count() > 1) {
    watch_.foresee(scene(), least_failing / loading_->load_of_step(), threads);
  }
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
      return mesh().period().shortest(p - position).squaredNorm() >= apart * apart;
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
  watch_.forget_foreseen();
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
  idle_growth_ = 0;
  updates_at_crack_ = element_updates();
  watch_.opened(scene(), v, normal, outcome_, changed_);
  relaxation_->mesh_changed(mesh(), outcome_);
  return true;
}

void Simulation::tell(const OnOpened& on_opened, std::size_t first) const {
  for (std::size_t i = first; i < opened_.size(); ++i) {
    const CrackSegment& s = opened_[i].geometry;
    on_opened(
        {static_cast<std::int64_t>(i), mesh().position(s.from_root), mesh().position(s.to_root)});
  }
}

void Simulation::run_on(const Vec3& start, const Vec3& normal, const CrackRules& rules) {
  const double length = relaxation_->stride();
  const auto may_run = [&](std::int32_t tip) {
    return (mesh().position_near(tip, start) - start).norm() < length &&
           std::isfinite(mean_factor(mesh(), fields_.toughness_scale, tip));
  };
  const std::vector<std::int32_t> tips = outcome_.tips;
  for (std::int32_t tip : tips) {
    // A plane meets each face once: around a closed surface the crack is back by then.
    for (std::int32_t faces = mesh().face_count(); may_run(tip) && faces > 0; --faces) {
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
  Heartbeat heartbeat(context, {"crack", -1, events_, mesh().face_count(), load()});
  loading_->bring_up(sheet_.field(), mesh(), [&](std::int32_t v, double force) {
    if (relaxation_->force_added(v, force)) changed_.push_back(v);
  });
  // 3b.i Relaxation.
  relaxation_->relax(
      sheet_.field(), mesh(), loading_->load(), context.threads, [&] { return heartbeat.stops(); },
      changed_);
  interrupted_ = heartbeat.stopped();
  if (interrupted_) return;
  // 3b.ii Shrinkage tension and curvature biasing.
  if (!loading_->grow(sheet_.field(), mesh())) return;
  idle_growth_ += mesh().face_count();
  for (std::int32_t v = 0; v < mesh().vertex_count(); ++v) changed_.push_back(v);
}

void Simulation::check_state() const {
  double sum = 0;  // not finite where any number is not
  for (const Vec4d& u : field().displacements()) sum += 0 * (u[0] + u[1] + u[2]);
  for (const Vec4d& f : field().forces()) sum += 0 * (f[0] + f[1] + f[2]);
  for (const Element& e : field().elements()) sum += 0 * (e.t[0] + e.t[1] + e.t[2]);
  if (sum == 0) return;
  throw Error(ErrorKind::request, "the simulation has left the range of numbers", "stress",
              "its stress is not finite; look for a stress, length or toughness far from the others"
              " in size");
}

void Simulation::update_failure_criteria(const Context& context) {
  const Stopwatch watch(times_.separation);
  watch_.look_at(scene(), changed_, context.threads);
  changed_.clear();
}

void Simulation::renumber(const Numbering& numbering) {
  const Numbering now = inverse(numbering);
  watch_.renumber(now.vertices);  // gives back memory
  sheet_.renumber(numbering);
  reorder(fields_.toughness_scale, numbering.faces);
  reorder(fields_.separation_scale, numbering.faces);
  reorder(fields_.preferred, numbering.faces);
  for (OpenedSegment& segment : opened_) {
    CrackSegment& s = segment.geometry;
    s.from_root = new_number(now.vertices, s.from_root);
    s.to_root = new_number(now.vertices, s.to_root);
    s.source_face = new_number(now.faces, s.source_face);
  }
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
